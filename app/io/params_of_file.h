// Takes parameters back from a file of any kind that this program writes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/io/png.h"
#include "pupflow/parameters.h"

namespace pupflow::io {

/// What a file says about its making in lines "# name = value". Refuses a film, and says how such a
/// file is made of it. Throws Failure.
TextEntries entries_of_text(const std::string& path);

/// What any file of this program says about its making. Throws Failure.
TextEntries entries_of_file(const std::string& path);

/// The parameters that made `path`, a PNG, CSV or HDF5 file written by this program; with `row`
/// those of that row (1 is the first) of a table of runs, whose columns name the parameters that
/// vary. Throws Failure.
Params params_of_file(const std::string& path, std::optional<std::int64_t> row = {});

}  // namespace pupflow::io
