// What a file is, told by its first bytes.
#pragma once

#include <string>
#include <string_view>

namespace pupflow::io {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
inline constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1a\n";

enum class FileKind {
  picture,  // PNG
  hdf5,     // a checkpoint or a recording, maybe unfinished or damaged
  text      // anything else
};

/// Throws Failure(bad_file) when it cannot be read.
FileKind file_kind(const std::string& path);

}  // namespace pupflow::io
