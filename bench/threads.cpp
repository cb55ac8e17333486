// One thread and two: a single big litter, and a sweep by the program.
#include <cstdio>
#include <filesystem>

#include "bench/child.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"

namespace pupflow::bench {
namespace {

/// Figure 2 in small: the same temperatures with fewer seeds and steps, everything else as there.
std::vector<std::string> small_figure2(int threads, const std::string& folder) {
  return {"figure2",     "--seeds",   "2",
          "--steps",     "400",       "--set",
          "discard=200", "--threads", std::to_string(threads),
          "--quiet",     "--force",   "--out",
          folder};
}

double figure2_time(int threads) {
  const std::string folder =
      (std::filesystem::temp_directory_path() / "pupflow-bench-figure2").string();
  std::filesystem::remove_all(folder);
  const double time = run_time(PUPFLOW_PROGRAM, small_figure2(threads, folder));
  std::filesystem::remove_all(folder);
  return time;
}

}  // namespace

void threads(int rounds, Verdicts& verdicts) {
  const std::vector<Contender> sweeps = {{"1", [] { return figure2_time(1); }},
                                         {"2", [] { return figure2_time(2); }}};
  const auto times = in_turns(sweeps, (rounds + 2) / 3);
  std::printf(
      "| small Figure 2, 48 runs | ms |\n|---|---|\n| one thread | %.0f |\n"
      "| two threads | %.0f |\n",
      median(times[0]), median(times[1]));
  verdicts.at_least("Figure 2, one thread through two", 1.85, ratio(times[0], times[1]));
}

}  // namespace pupflow::bench
