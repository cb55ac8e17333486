#include "app/io/file_kind.h"

#include "app/io/read_file.h"
#include "app/io/user_block.h"

namespace pupflow::io {

FileKind file_kind(const std::string& path) {
  const std::string beginning = read_beginning(path, kUserBlock + kHdf5Signature.size());
  const std::string_view bytes = beginning;
  if (bytes.starts_with(kPngSignature)) return FileKind::picture;
  const bool hdf5 = bytes.starts_with(kHdf5Signature) || bytes.ends_with(kHdf5Signature) ||
                    bytes.starts_with("pupflow checkpoint") ||
                    bytes.starts_with("pupflow recording");
  return hdf5 ? FileKind::hdf5 : FileKind::text;
}

}  // namespace pupflow::io
