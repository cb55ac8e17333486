// What a file of this program holds, whatever its kind.
#pragma once

#include <string>
#include <vector>

#include "app/io/data_set.h"
#include "app/io/png.h"
#include "pupflow/parameters.h"

namespace pupflow::io {

/// What there is to tell of a file.
struct About {
  std::string kind;      // "recording", "picture", ...
  std::string software;  // that wrote it
  Params params;
  TextEntries facts;          // anything else, by name: sizes, steps, what it says of itself
  std::vector<SetInfo> sets;  // data sets, or columns
};

/// What `path` holds: PNG, CSV or HDF5. Throws Failure: bad_file when it cannot be read, bad_input
/// when this program did not write it.
About about_file(const std::string& path);

}  // namespace pupflow::io
