// Whole steps.
#include <benchmark/benchmark.h>

#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr std::int64_t kHashedSteps = 20;  // beyond the common start

/// How one benchmark goes about a step.
struct Way {
  std::string name;
  Params params;
  InstructionSet set = supported_instruction_sets().back();
  int threads = 1;
};

void measure_step(benchmark::State& state, const Way& way) {
  Simulation simulation(settled(way.params).snapshot(), way.set);
  simulation.set_threads(way.threads);
  Simulation hashed = simulation;
  if (!hashed.run(kHashedSteps).ok()) state.SkipWithError(hashed.status().message().c_str());
  state.SetLabel("hash " + hash_text(hashed.hash()));
  for (auto _ : state) benchmark::DoNotOptimize(simulation.step());
  state.counters["pup_step"] = benchmark::Counter(
      way.params.pups, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void add(const Way& way) {
  benchmark::RegisterBenchmark(("step/" + way.name).c_str(), measure_step, way)
      ->Unit(benchmark::kMicrosecond)
      ->UseRealTime();
}

void add_scenes(Precision precision, const std::string& in) {
  for (const double ta : {0.0, 0.4, 0.6, 0.8, 1.0}) {
    Params params = huddling(precision);
    params.ambient_temperature = ta;
    add({"ta=" + std::to_string(ta).substr(0, 3) + "/" + in, params});
  }
  for (const int k : {2, 4, 10, 16, 32}) {
    Params params = huddling(precision);
    params.face_points = k;
    add({"face_points=" + std::to_string(k) + "/" + in, params});
  }
  for (const int pups : {1, 12, 100, 1000, 10000}) {
    add({"pups=" + std::to_string(pups) + "/" + in, crowd(pups, precision)});
  }
}

void add_ways(Precision precision, const std::string& in) {
  for (const InstructionSet set : supported_instruction_sets()) {
    const std::string name(instruction_set_name(set));
    add({"huddling/" + in + "/" + name, huddling(precision), set});
  }
  for (const int threads : {1, 2, 4, 8}) {
    const std::string name = "/threads=" + std::to_string(threads);
    const InstructionSet best = supported_instruction_sets().back();
    add({"huddling/" + in + name, huddling(precision), best, threads});
    add({"crowd/" + in + name, crowd(200, precision), best, threads});
  }
}

}  // namespace

void register_steps() {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    const std::string in = precision_name(precision);
    add_ways(precision, in);
    add_scenes(precision, in);
  }
}

}  // namespace pupflow::bench
