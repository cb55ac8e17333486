// What every output carries so that it can be made again.
#pragma once

#include <string>

#include "app/io/png.h"
#include "engine/params.h"

namespace pupflow::io {

/// The program's version.
std::string version();

/// Program version, then every parameter (the seed among them) by name; values read back to the
/// same parameters. `extra` entries (e.g. the step of a picture) follow.
TextEntries provenance(const Params& params, const TextEntries& extra = {});

/// The parameters in such entries; entries that are no parameters are skipped. Throws
/// Failure(bad_input), naming `where`, when a parameter is missing or its value is bad.
Params params_from(const TextEntries& entries, const std::string& where);

/// The parameters that made `path`, a PNG, CSV or HDF5 file written by this program. Throws
/// Failure.
Params params_of_file(const std::string& path);

}  // namespace pupflow::io
