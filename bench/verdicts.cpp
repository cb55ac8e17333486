#include "bench/verdicts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace pupflow::bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Aim {
  std::string_view what;
  enum class Relation { at_least, at_most } relation;
  double target;
  double before;  // with version 0.1.0, or kNone
};

constexpr auto kAtLeast = Aim::Relation::at_least, kAtMost = Aim::Relation::at_most;

// The figures of version 0.1.0 are those of its own docs/performance.md, in commit 04db594: summed
// contacts, 500 steps after the start, an Intel Xeon processor with AVX-512. Those at T_a 0.5 and
// 0.8 are from its benchmarks in commit 50a29f8 with that temperature, 800 steps after the start, on
// an AMD EPYC processor with AVX-512. No ratio at these temperatures shall be worse than it was.
constexpr Aim kAims[] = {
    {"memory of a pup in float, kB", kAtMost, 40, 10.29},
    {"a pup's step, 10,000 through 12 pups, in float", kAtMost, 1.3, 1.419},
    {"a pup's step, 10,000 through 12 pups, in double", kAtMost, 1.3, 1.549},
    {"step in float against the paper's manner", kAtLeast, 1000, 1025},
    {"step in double against the paper's manner", kAtLeast, 600, 883.2},
    {"step in float against plain Eigen in double, T_a 0.2", kAtLeast, 12, 6.357},
    {"step in float against plain Eigen in double, T_a 0.5", kAtLeast, 7.3, 7.3},
    {"step in float against plain Eigen in double, T_a 0.8", kAtLeast, 7.9, 7.9},
    {"step in double against plain Eigen in double, T_a 0.2", kAtLeast, 8, 5.459},
    {"step in double against plain Eigen in double, T_a 0.5", kAtLeast, 5.3, 5.3},
    {"step in double against plain Eigen in double, T_a 0.8", kAtLeast, 5.5, 5.5},
    {"contacts, sum through nearest, T_a 0.2, in float", kAtLeast, 1.5, kNone},
    {"contacts, sum through nearest, T_a 0.5, in float", kAtLeast, 1.5, kNone},
    {"contacts, sum through nearest, T_a 0.8, in float", kAtLeast, 1.5, kNone},
    {"contacts, sum through nearest, T_a 0.2, in double", kAtLeast, 1.5, kNone},
    {"contacts, sum through nearest, T_a 0.5, in double", kAtLeast, 1.5, kNone},
    {"contacts, sum through nearest, T_a 0.8, in double", kAtLeast, 1.5, kNone},
    {"contacts, dispersed through huddling, in float", kAtMost, 0.2, 0.1119},
    {"contacts, dispersed through huddling, in double", kAtMost, 0.2, 0.1384},
    {"shape matching, β = 0 through β = 0.5, in float", kAtMost, 0.75, 0.7181},
    {"shape matching, β = 0 through β = 0.5, in double", kAtMost, 0.75, 0.725},
    {"shape matching through its tight kernel (avx2), in float", kAtMost, 1.5, 1.606},
    {"shape matching through its tight kernel (avx2), in double", kAtMost, 1.5, 1.42},
    {"run with pup recorded through one without", kAtMost, 1.1, kNone},
    {"run with afferent recorded through one without", kAtMost, 1.5, kNone},
    {"memory of 1,800 more frames, MB", kAtMost, 4, kNone},
    {"Figure 2, one thread through two", kAtLeast, 1.85, 1.962},
    {"1,000 pups, one thread through two, in float", kAtLeast, 1.6, 1.705},
    {"1,000 pups, one thread through two, in double", kAtLeast, 1.6, 1.773},
    {"`pupflow run --steps 0`, ms", kAtMost, 50, 6.609},
    {"drawing the litter through the baseline's drawing", kAtMost, 1.3, 1.28},
    {"a frame as version 0.1.0 drew it through one of today, 12 pups, 1280 × 960", kAtLeast, 3,
     kNone},
    {"a frame as version 0.1.0 drew it through one of today, 12 pups, 640 × 480", kAtLeast, 2,
     kNone},
    {"a frame as version 0.1.0 drew it through one of today, 1000 pups, 1280 × 960", kAtLeast, 4,
     kNone},
};

void print_row(const Aim& aim, double measured) {
  const bool more = aim.relation == Aim::Relation::at_least;
  const double missing = more ? aim.target / measured : measured / aim.target;
  std::printf("| %s | %s %g | %.4g | ", std::string(aim.what).c_str(), more ? "≥" : "≤", aim.target,
              measured);
  if (missing <= 1) {
    std::printf("reached |");
  } else {
    std::printf("missed by a factor of %.4g |", missing);
  }
  if (std::isnan(aim.before)) {
    std::printf(" – |\n");
  } else {
    std::printf(" %.4g |\n", aim.before);
  }
}

}  // namespace

void Verdicts::measured(const std::string& what, double value) {
  if (std::ranges::find(kAims, what, &Aim::what) == std::end(kAims)) {
    throw std::logic_error("there is no aim '" + what + "'");
  }
  measured_[what] = value;
}

void Verdicts::print() const {
  if (measured_.empty()) return;
  std::printf("| target | wanted | measured | | version 0.1.0 |\n|---|---|---|---|---|\n");
  for (const Aim& aim : kAims) {
    const auto found = measured_.find(std::string(aim.what));
    if (found != measured_.end()) print_row(aim, found->second);
  }
}

}  // namespace pupflow::bench
