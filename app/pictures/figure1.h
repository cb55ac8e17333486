// The paper's Figure 1: what the litter looks like from above at several ambient temperatures.
#pragma once

#include <vector>

#include "app/pictures/look.h"
#include "pupflow/parameters.h"

namespace pupflow::pictures {

/// `pupflow figure1`: the paper's Figure 1.
struct Figure1Job {
  Params params;                             // everything but ta
  std::vector<double> ta = {0.2, 0.5, 0.8};  // one panel each
  int panel = 560;                           // edge of a panel, pixels
  int threads = 1;                           // that step the litters
  Look look;
  Output output;
};

/// Runs one litter per temperature and writes the figure. All panels have one color scale, unless
/// their values decide its ends: then each has its own. Throws
/// Failure: bad_input, bad_file (before anything is run when the output exists), bad_numbers,
/// no_context, interrupted; nothing is written then.
void figure1(const Figure1Job& job);

}  // namespace pupflow::pictures
