// Where a run begins: a new litter, or that of a checkpoint.
#pragma once

#include <optional>
#include <string>

#include "app/cli/verb.h"
#include "pupflow/simulation.h"

namespace pupflow::cli {

/// Declares --from.
void add_from(CLI::App& verb, std::string& from);

struct Start {
  Params recipe;                 // what was typed; with --from also what the checkpoint tells
  std::optional<Snapshot> from;  // the litter of --from, for which the recipe holds
  std::string title;             // of the scene; empty without one
};

/// The start that `settings` and the checkpoint `from` (empty: none) describe. What is typed beside
/// --from changes the run at the checkpoint's step. Throws io::Failure: bad_input, also where the
/// checkpoint lies beyond the run's last step; bad_file.
Start start_of(const io::Settings& settings, const std::string& from);

/// The litter there.
Simulation litter_of(const Start& start);

}  // namespace pupflow::cli
