// Steps the paper's litter as it huddles at T_a = 0.2, for bench/python_steps.py. For each line read,
// a number of steps, it takes these from step 500 on, one by one, and prints the seconds of processor
// time and the hash.
#include <cinttypes>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <string>

#include "pupflow/simulation.h"

int main() {
  const auto seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  pupflow::Params params;
  params.ambient_temperature = 0.2;
  pupflow::Simulation start(params);
  start.run(500);
  for (int steps = 0; std::cin >> steps;) {
    pupflow::Simulation litter(start);
    const double before = seconds();
    for (int i = 0; i < steps; ++i) litter.step();
    std::printf("%.9g %016" PRIx64 "\n", seconds() - before, litter.hash());
    std::fflush(stdout);
  }
}
