// One thread and two: a single big litter, and a sweep by the program. The least times count, since
// two threads are as fast as they can be only while nobody else wants either core.
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "bench/child.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

/// The whole of Figure 2 by the program, its picture included; milliseconds.
double figure2_time(int threads) {
  const std::string folder =
      (std::filesystem::temp_directory_path() / "pupflow-bench-figure2").string();
  std::filesystem::remove_all(folder);
  const double time = run_time(PUPFLOW_PROGRAM, {"figure2", "--threads", std::to_string(threads),
                                                 "--quiet", "--out", folder});
  std::filesystem::remove_all(folder);
  return time;
}

constexpr int kCrowd = 1000, kSteps = 30;

/// Microseconds of a step of `start` on so many threads.
double crowd_time(const Simulation& start, int threads, std::uint64_t& hash) {
  Simulation simulation = start;
  simulation.set_threads(threads);
  const double time = least_step_time(simulation, kSteps);
  hash = simulation.hash();
  return time;
}

void one_crowd(int rounds, Verdicts& verdicts) {
  std::printf(
      "\n| %d pups, a step | one thread, µs | two threads | hash of either |\n|---|---|---|---|\n",
      kCrowd);
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    const Simulation& start = settled(crowd(kCrowd, precision), kLanded);
    std::uint64_t hashes[2]{};
    const std::vector<Contender> contenders = {
        {"1", [&] { return crowd_time(start, 1, hashes[0]); }},
        {"2", [&] { return crowd_time(start, 2, hashes[1]); }}};
    const auto times = in_turns(contenders, rounds);
    if (hashes[0] != hashes[1]) throw std::runtime_error("two threads gave another hash than one");
    const std::string name = precision_name(precision);
    std::printf("| %s | %.0f | %.0f | %s |\n", name.c_str(), least(times[0]), least(times[1]),
                hash_text(hashes[0]).c_str());
    verdicts.measured("1,000 pups, one thread through two, in " + name,
                      least(times[0]) / least(times[1]));
  }
}

void figure2(int rounds, Verdicts& verdicts) {
  const std::vector<Contender> sweeps = {{"1", [] { return figure2_time(1); }},
                                         {"2", [] { return figure2_time(2); }}};
  const auto times = in_turns(sweeps, (rounds + 4) / 5);
  std::printf("| `pupflow figure2`, 240 runs | s |\n|---|---|\n");
  std::printf("| one thread | %.1f |\n| two threads | %.1f |\n", 1e-3 * least(times[0]),
              1e-3 * least(times[1]));
  verdicts.measured("Figure 2, one thread through two", least(times[0]) / least(times[1]));
}

}  // namespace

void threads(int rounds, Verdicts& verdicts) {
  figure2(rounds, verdicts);
  one_crowd(rounds, verdicts);
}

}  // namespace pupflow::bench
