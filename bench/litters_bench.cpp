// Observables, snapshots, copies, hashes and ensembles.
#include <benchmark/benchmark.h>

#include "bench/benchmarks.h"
#include "bench/scenes.h"
#include "pupflow/ensemble.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kRuns = 8, kSteps = 100;  // of one ensemble

void observe(benchmark::State& state) {
  const Simulation& litter = settled(huddling(Precision::float_));
  Observer observer(litter);
  for (auto _ : state) benchmark::DoNotOptimize(observer.observe(litter));
}

void take_snapshot(benchmark::State& state) {
  const Simulation& litter = settled(huddling(Precision::float_));
  for (auto _ : state) benchmark::DoNotOptimize(litter.snapshot());
}

void restore_snapshot(benchmark::State& state) {
  const Snapshot snapshot = settled(huddling(Precision::float_)).snapshot();
  for (auto _ : state) benchmark::DoNotOptimize(Simulation(snapshot));
}

void copy(benchmark::State& state) {
  const Simulation& litter = settled(huddling(Precision::float_));
  for (auto _ : state) benchmark::DoNotOptimize(Simulation(litter));
}

void hash(benchmark::State& state) {
  const Simulation& litter = settled(huddling(Precision::float_));
  for (auto _ : state) benchmark::DoNotOptimize(litter.hash());
}

void start(benchmark::State& state) {
  const Params params = huddling(Precision::float_);
  for (auto _ : state) benchmark::DoNotOptimize(Simulation(params));
}

void ensemble(benchmark::State& state, int threads) {
  const auto params_of = [](std::int64_t run) {
    Params params = huddling(Precision::float_);
    params.seed = run + 1;
    params.steps = kSteps;
    params.discard = kSteps / 2;
    return params;
  };
  for (auto _ : state) {
    double huddled = 0;
    run_ensemble(
        kRuns, threads, params_of,
        [&](std::int64_t, const RunResult& result) { huddled += result.means.huddling; },
        [] { return false; });
    benchmark::DoNotOptimize(huddled);
  }
}

}  // namespace

void register_litters() {
  const auto add = [](const char* name, auto measure) {
    benchmark::RegisterBenchmark(name, measure)->Unit(benchmark::kMicrosecond);
  };
  add("litter/observe", observe);
  add("litter/snapshot", take_snapshot);
  add("litter/restore", restore_snapshot);
  add("litter/copy", copy);
  add("litter/hash", hash);
  add("litter/start", start);
  for (const int threads : {1, 2, 4}) {
    benchmark::RegisterBenchmark(("ensemble/threads=" + std::to_string(threads)).c_str(), ensemble,
                                 threads)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace pupflow::bench
