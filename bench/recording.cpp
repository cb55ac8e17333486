// What recording every step costs: time of a whole run, and memory.
#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "app/io/provenance.h"
#include "app/io/recording.h"
#include "bench/child.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kSteps = 640;  // ten chunks of frames

std::string scratch_path() {
  return (std::filesystem::temp_directory_path() / "pupflow-bench-recording.h5").string();
}

/// Steps `simulation` on and records `fields` of each step; nothing where there is no name.
void run_recorded(Simulation& simulation, const std::string& fields, int steps) {
  simulation.set_observed({});
  if (fields.empty()) {
    simulation.run(steps);
    return;
  }
  const Params& params = simulation.params();
  const io::RecordedFields recorded = io::parse_recorded_fields(fields);
  simulation.set_observed(recorded.parts());
  io::Recording recording(scratch_path(), true, params, io::provenance(params), recorded);
  for (int i = 0; i < steps; ++i) {
    simulation.step();
    recording.add(simulation);
  }
  recording.commit("");
}

/// A litter with a choice of fields: one measurement a round, in microseconds a step.
struct Recorded {
  std::vector<double> busy;  // the processor's time for the thread that steps
  std::uint64_t hash = 0;    // at the end

  /// The whole run, the recording included.
  double measure(const Simulation& start, const std::string& fields) {
    Simulation simulation = start;
    const double time = microseconds([&] {
      busy.push_back(busy_microseconds([&] { run_recorded(simulation, fields, kSteps); }) / kSteps);
    });
    hash = simulation.hash();
    return time / kSteps;
  }
};

struct Row {
  const char* name;
  const char* fields;
};
constexpr std::array<Row, 4> kRows{{{"nothing", ""},
                                    {"pup (the default)", "pup"},
                                    {"afferent", "afferent"},
                                    {"pup, afferent, point", "pup,afferent,point"}}};

/// Prints a row for each choice of fields, and returns the ratios of their times to that of the run
/// that records nothing.
std::array<double, kRows.size()> measure_litter(const char* name, const Params& params,
                                                int rounds) {
  const Simulation& start = settled(params);
  std::array<Recorded, kRows.size()> runs{};
  std::vector<Contender> contenders;
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    contenders.push_back(
        {kRows[i].name, [&, i] { return runs[i].measure(start, kRows[i].fields); }});
  }
  const auto times = in_turns(contenders, rounds);
  std::array<double, kRows.size()> ratios{};
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (runs[i].hash != runs[0].hash) throw std::runtime_error("recording changed the run");
    ratios[i] = least(times[i]) / least(times[0]);
    const double busy = median(runs[i].busy);
    std::printf("| %s, %s | %.1f | %.2f | %.1f | %.2f |\n", name, kRows[i].name, least(times[i]),
                ratios[i], busy, ratio(runs[i].busy, runs[0].busy));
  }
  return ratios;
}

/// Records every field of so many steps.
void record_all(int steps) {
  Simulation simulation(huddling(Precision::double_));
  run_recorded(simulation, "pup,afferent,point", steps);
}

}  // namespace

void recording(int rounds, Verdicts& verdicts) {
  constexpr int kFew = 200, kMany = 2000;
  const double few = peak_memory(record_all, kFew), many = peak_memory(record_all, kMany);
  std::printf(
      "| recorded every step | µs a step | times as long as unrecorded | µs of the thread that "
      "steps "
      "| times |\n|---|---|---|---|---|\n");
  const auto cold = measure_litter("huddling", huddling(Precision::double_), rounds);
  measure_litter("dispersed", dispersed(Precision::double_), rounds);
  std::printf("\nA run that records all fields of %d steps takes %.0f MB, of %d steps %.0f MB.\n",
              kFew, few / 1e6, kMany, many / 1e6);
  verdicts.measured("run with pup recorded through one without", cold[1]);
  verdicts.measured("run with afferent recorded through one without", cold[2]);
  verdicts.measured("memory of 1,800 more frames, MB", (many - few) / 1e6);
  std::filesystem::remove(scratch_path());
}

}  // namespace pupflow::bench
