// What a sweep over T_a shows of the phase transition, in the words of the paper's Figure 2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// How near to T_p the litter's mean T_b must be for it to count as holding its temperature.
constexpr double kHeld = 0.03;

/// An interval of T_a.
struct Range {
  double from, to;
  friend bool operator==(const Range&, const Range&) = default;
};

/// The T_a at which mean T_b is within kHeld of T_p, with straight lines between the points of the
/// sweep; several ranges where they do not hang together. `axis` is that of ta. Points without a
/// fine run interrupt a range.
std::vector<Range> held_ranges(const Design& design, const std::vector<Summary>& summaries,
                               std::size_t axis);

/// Where something is highest, and how high that is.
struct Peak {
  double ta, value;
};

struct Transition {
  std::optional<Range> steepest;  // neighbouring T_a between which 1 - A falls most, if it does
  Peak exposed_sd, flow;          // standard deviation of A, pup flow
  std::vector<Range> held;        // held_ranges
};

/// Nothing unless ta is the only varied parameter, rising, with at least two values whose runs were
/// fine.
std::optional<Transition> find_transition(const Design& design,
                                          const std::vector<Summary>& summaries);

/// Four lines for people.
std::string transition_text(const Design& design, const Transition& transition);

}  // namespace pupflow::study
