// What every output carries so that it can be made again.
#pragma once

#include <string>
#include <vector>

#include "app/io/png.h"
#include "pupflow/parameters.h"

namespace pupflow::io {

/// The program's version.
std::string version();

/// Program version, then every parameter (the seed among them) by name; values read back to the
/// same parameters. `extra` entries (e.g. the step of a picture) follow.
TextEntries provenance(const Params& params, const TextEntries& extra = {});

/// The parameters in such entries; entries that are no parameters are skipped. A parameter that is
/// missing takes its value by take_as_before. Throws Failure(bad_input), naming `where`, when the
/// entries were not written by this program or a value is bad.
Params params_from(const TextEntries& entries, const std::string& where);

/// Sets the parameters `missing` in a file of an older version to what that version did
/// (Parameter::before), and says so in one line on standard error. Does nothing when none is
/// missing.
void take_as_before(const std::vector<const Parameter*>& missing, const std::string& where,
                    Params& params);

}  // namespace pupflow::io
