// What a file is, told by its first bytes.
#pragma once

#include <string>

namespace pupflow::io {

enum class FileKind {
  picture,  // PNG
  hdf5,     // a checkpoint or a recording, maybe unfinished or damaged
  text      // anything else
};

/// Throws Failure(bad_file) when it cannot be read, Failure(bad_input) when only its name is that of
/// HDF5.
FileKind file_kind(const std::string& path);

}  // namespace pupflow::io
