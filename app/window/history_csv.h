// What the plots show, as CSV.
#pragma once

#include <string>

#include "app/window/controls.h"
#include "app/window/session/session.h"

namespace pupflow::window {

/// The samples of these steps as a CSV file of the program: the header that every one has, then a
/// row for each of the finest samples that are kept. A row of one step begins as that of the
/// metrics CSV; where a sample stands for several steps, it has their means.
std::string history_csv(const LitterState& state, StepRange steps);

/// Writes it to a new file beside the pictures: `pattern` is theirs (see picture_path), its ending
/// becomes .csv. Returns the path. Throws io::Failure.
std::string save_history_csv(const std::string& pattern, const LitterState& state, StepRange steps);

}  // namespace pupflow::window
