// The phase transition in a sweep over T_a, as in the paper's Figure 2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// The litter holds its temperature where |mean T_b - T_p| is at most this.
constexpr double kHeld = 0.03;

/// An interval of T_a.
struct Range {
  double from, to;
  friend bool operator==(const Range&, const Range&) = default;
};

/// The ranges of T_a in which mean T_b, interpolated linearly between the points of the sweep, is
/// within kHeld of T_p. `axis` is that of ta. A point without a fine run ends a range.
std::vector<Range> held_ranges(const Design& design, const std::vector<Summary>& summaries,
                               std::size_t axis);

/// The highest value, and its T_a.
struct Peak {
  double ta, value;
};

struct Transition {
  std::optional<Range> steepest;  // neighbouring T_a between which 1 - A falls most, if it does
  Peak exposed_sd, flow;          // standard deviation of A, pup flow
  std::vector<Range> held;        // held_ranges
};

/// Empty unless ta is the only varied parameter and has at least two points, in any order, all with
/// fine runs.
std::optional<Transition> find_transition(const Design& design,
                                          const std::vector<Summary>& summaries);

/// Four lines of text; with `celsius` T_a in degrees, too.
std::string transition_text(const Design& design, const Transition& transition,
                            bool celsius = false);

}  // namespace pupflow::study
