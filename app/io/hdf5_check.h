// What a file from elsewhere may have that no file of this program has.
#pragma once

#include <hdf5.h>

#include <string>

namespace pupflow::io {

/// Looks at every link and data set of `file` without following links or reading numbers. Returns
/// what is not as this program writes it, such as "'x' is a link to another place"; empty when all
/// is.
std::string foreign_part(hid_t file);

}  // namespace pupflow::io
