// Starting the program.
#include <cstdio>

#include "bench/child.h"
#include "bench/measure.h"
#include "bench/sections.h"

namespace pupflow::bench {

void start_up(int rounds, Verdicts& verdicts) {
  const std::vector<Contender> start = {
      {"start", [] {
         return run_time(PUPFLOW_PROGRAM, {"run", "--steps", "0", "--quiet"});
       }}};
  const std::vector<double> times = in_turns(start, 3 * rounds).front();
  std::printf("`pupflow run --steps 0` takes %.1f ms.\n", median(times));
  verdicts.measured("`pupflow run --steps 0`, ms", median(times));
}

}  // namespace pupflow::bench
