// Prints the hash of every golden run for each instruction set and for one to three threads, a line
// each, and marks those that differ from the table. Exit code 1 when one does.
#include <cinttypes>
#include <cstdio>

#include "pupflow/simulation.h"
#include "tests/golden/golden_runs.h"

namespace {

using namespace pupflow;

bool is_equal(const GoldenRun& run, InstructionSet set, int threads) {
  Simulation simulation(params_of(run), set);
  simulation.set_threads(threads);
  const bool equal = simulation.run(kGoldenSteps).ok() && simulation.hash() == run.hash;
  std::printf("%-18s %-8s %d threads  %016" PRIx64 "%s\n", run.name,
              std::string(instruction_set_name(set)).c_str(), threads, simulation.hash(),
              equal ? "" : "  DIFFERS");
  return equal;
}

}  // namespace

int main() {
  bool all_equal = true;
  const auto sets = supported_instruction_sets();
  for (const GoldenRun& run : kGoldenRuns) {
    for (const InstructionSet set : sets) all_equal = is_equal(run, set, 1) && all_equal;
    for (const int threads : {2, 3}) all_equal = is_equal(run, sets.back(), threads) && all_equal;
  }
  return all_equal ? 0 : 1;
}
