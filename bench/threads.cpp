// One thread and two: a single big litter, and a sweep by the program.
#include <cstdio>
#include <filesystem>
#include <stdexcept>

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

constexpr int kCrowd = 1000, kSteps = 30;

/// Microseconds of a step of `start` on so many threads.
double crowd_time(const Simulation& start, int threads, std::uint64_t& hash) {
  Simulation simulation = start;
  simulation.set_threads(threads);
  const double time = step_time(simulation, kSteps);
  hash = simulation.hash();
  return time;
}

void one_crowd(int rounds, Verdicts& verdicts) {
  std::printf(
      "\n| %d pups, a step | one thread, µs | two threads | hash of either |\n|---|---|---|---|\n",
      kCrowd);
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    const Simulation& start = settled(crowd(kCrowd, precision));
    std::uint64_t hashes[2]{};
    const std::vector<Contender> contenders = {
        {"1", [&] { return crowd_time(start, 1, hashes[0]); }},
        {"2", [&] { return crowd_time(start, 2, hashes[1]); }}};
    const auto times = in_turns(contenders, rounds);
    if (hashes[0] != hashes[1]) throw std::runtime_error("two threads gave another hash than one");
    const std::string name = precision_name(precision);
    std::printf("| %s | %.0f | %.0f | %s |\n", name.c_str(), median(times[0]), median(times[1]),
                hash_text(hashes[0]).c_str());
    verdicts.at_least("1,000 pups, one thread through two, in " + name, 1.6,
                      ratio(times[0], times[1]));
  }
}

void figure2(int rounds, Verdicts& verdicts) {
  const std::vector<Contender> sweeps = {{"1", [] { return figure2_time(1); }},
                                         {"2", [] { return figure2_time(2); }}};
  const auto times = in_turns(sweeps, (rounds + 2) / 3);
  std::printf(
      "| small Figure 2, 48 runs | ms |\n|---|---|\n| one thread | %.0f |\n"
      "| two threads | %.0f |\n",
      median(times[0]), median(times[1]));
  verdicts.at_least("Figure 2, one thread through two", 1.85, ratio(times[0], times[1]));
}

}  // namespace

void threads(int rounds, Verdicts& verdicts) {
  figure2(rounds, verdicts);
  one_crowd(rounds, verdicts);
}

}  // namespace pupflow::bench
