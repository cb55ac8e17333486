// What every output carries so that it can be made again.
#pragma once

#include <string>
#include <vector>

#include "app/io/png.h"
#include "pupflow/simulation.h"

namespace pupflow::io {

/// "pupflow" and the version.
std::string program_version();

/// Program version, then every parameter (the seed among them) by name, then the schedule as `at`
/// where there is one; values read back to the same parameters. `extra` entries (e.g. the step of a picture) follow; the first of them must be
/// called picture, command or manifest, which ends the parameters for who reads them. Throws
/// std::logic_error otherwise.
TextEntries provenance(const Params& params, const TextEntries& extra = {});

/// The same of the recipe of a run that goes on from `start`, then `begun`, the steps done there, and
/// `edited` as add_state writes it; either only where there is something to say.
TextEntries provenance(const Simulation& start);

/// Adds entries about the state of a picture or a file: `step`, `hash` and, where pups were set by
/// hand, `edited`, the step after which they first were.
void add_state(const Simulation& litter, TextEntries& entries);

/// The parameters in such entries. A parameter that is missing takes its value by take_as_before.
/// Throws Failure(bad_input), naming `where`, when the entries were not written by this program, a
/// value is bad, or there is a parameter that this version does not know.
Params params_from(const TextEntries& entries, const std::string& where);

/// Sets the parameters `missing` in a file of an older version to what that version did
/// (Parameter::before), and says so in one line on standard error. Does nothing when none is
/// missing.
void take_as_before(const std::vector<const Parameter*>& missing, const std::string& where,
                    Params& params);

}  // namespace pupflow::io
