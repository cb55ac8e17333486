#include "bench/verdicts.h"

#include <cstdio>

namespace pupflow::bench {

void Verdicts::at_least(const std::string& what, double target, double measured) {
  rows_.push_back({what, target, measured, true});
}

void Verdicts::at_most(const std::string& what, double target, double measured) {
  rows_.push_back({what, target, measured, false});
}

void Verdicts::print() const {
  if (rows_.empty()) return;
  std::printf("| target | wanted | measured | |\n|---|---|---|---|\n");
  for (const Row& row : rows_) {
    const bool reached = row.at_least ? row.measured >= row.target : row.measured <= row.target;
    const double missing = row.at_least ? row.target / row.measured : row.measured / row.target;
    std::printf("| %s | %s %g | %.4g | ", row.what.c_str(), row.at_least ? "≥" : "≤", row.target,
                row.measured);
    if (reached) {
      std::printf("reached |\n");
    } else {
      std::printf("missed by a factor of %.2f |\n", missing);
    }
  }
}

}  // namespace pupflow::bench
