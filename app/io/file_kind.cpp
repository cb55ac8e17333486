#include "app/io/file_kind.h"

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/user_block.h"

namespace pupflow::io {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// A kill may come between making a file and writing to it.
void refuse_not_begun(const std::string& path, std::string_view bytes) {
  const bool empty = bytes.substr(0, kUserBlock).find_first_not_of('\0') == std::string_view::npos;
  if (!empty || !path.ends_with(kUnfinished)) return;
  throw Failure(ExitCode::bad_file, path +
                                        ": is unfinished: its run ended before anything was "
                                        "written");
}

}  // namespace

FileKind file_kind(const std::string& path) {
  const std::string beginning = read_beginning(path, kUserBlock + kHdf5Signature.size());
  const std::string_view bytes = beginning;
  refuse_not_begun(path, bytes);
  if (bytes.starts_with(kPngSignature)) return FileKind::picture;
  const bool hdf5 = bytes.starts_with(kHdf5Signature) || bytes.ends_with(kHdf5Signature) ||
                    bytes.starts_with("pupflow checkpoint") ||
                    bytes.starts_with("pupflow recording");
  if (!hdf5 && path.ends_with(".h5") && !bytes.starts_with('#')) {
    refuse(path + ": is no recording or checkpoint, which its name says; it does not begin as one");
  }
  return hdf5 ? FileKind::hdf5 : FileKind::text;
}

}  // namespace pupflow::io
