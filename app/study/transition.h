// Where a sweep over T_a has its phase transition, in the words of the paper's Figure 2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

struct Transition {
  double steepest_from, steepest_to;  // the pair of neighbouring T_a between which 1 - A falls most
  double flow_peak_ta, flow_peak;     // where pup flow is highest
  std::optional<double> warm_flow;    // its mean over T_a >= 0.6, when the sweep goes there
};

/// Nothing unless ta is the only varied parameter, rising, with at least two values whose runs were
/// fine.
std::optional<Transition> find_transition(const Design& design,
                                          const std::vector<Summary>& summaries);

/// Two lines for people.
std::string transition_text(const Design& design, const Transition& transition);

}  // namespace pupflow::study
