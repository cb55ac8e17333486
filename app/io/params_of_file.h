// Takes parameters back from a file of any kind that this program writes.
#pragma once

#include <string>

#include "pupflow/parameters.h"

namespace pupflow::io {

/// The parameters that made `path`, a PNG, CSV or HDF5 file written by this program. Throws
/// Failure.
Params params_of_file(const std::string& path);

}  // namespace pupflow::io
