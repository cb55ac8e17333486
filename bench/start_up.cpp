// Starting the program.
#include <cstdio>

#include "bench/child.h"
#include "bench/measure.h"
#include "bench/sections.h"

namespace pupflow::bench {

void start_up(int rounds, Verdicts& verdicts) {
  std::vector<double> times;
  for (int i = 0; i < 3 * rounds; ++i) {
    times.push_back(run_time(PUPFLOW_PROGRAM, {"run", "--steps", "0", "--quiet"}));
  }
  std::printf("`pupflow run --steps 0` takes %.1f ms.\n", median(times));
  verdicts.at_most("`pupflow run --steps 0`, ms", 50, median(times));
}

}  // namespace pupflow::bench
