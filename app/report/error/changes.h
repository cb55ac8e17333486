// The settings of a run that a user can change.
#pragma once

#include <string>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::report {

/// One setting: its parameters include the steps and the discard of its means.
struct Change {
  std::string group;  // what is changed, e.g. "time step"; empty for the base
  std::string label;  // to what, e.g. "dt = 0.005, naive"
  Params params;      // may be invalid: then the change is not possible here
};

/// `base` first, then: twice and half its time step, consistent refinement, fewer and more points a
/// pup, the other precision, integrator and heat rule, runs of half to `longest` (2 or more) times
/// as many steps, and other windows for the means.
std::vector<Change> changes_of(const Params& base, int longest);

}  // namespace pupflow::report
