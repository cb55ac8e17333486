// Each stage of a step.
#include <benchmark/benchmark.h>

#include <chrono>

#include "bench/benchmarks.h"
#include "bench/scenes.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

/// Times one stage of a step, in seconds.
class OneStage : public StageListener {
 public:
  explicit OneStage(Stage stage) : stage_(stage) {}
  void stage_begins(Stage stage) override {
    if (stage == stage_) begin_ = std::chrono::steady_clock::now();
  }
  void stage_ends(Stage stage) override {
    if (stage == stage_) time_ = std::chrono::steady_clock::now() - begin_;
  }
  double seconds() const { return time_.count(); }

 private:
  Stage stage_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::duration<double> time_{0};
};

void measure_stage(benchmark::State& state, const Params& params, Stage stage) {
  Simulation simulation = settled(params);
  OneStage clock(stage);
  for (auto _ : state) {
    simulation.step(&clock);
    state.SetIterationTime(clock.seconds());
  }
}

void add(const std::string& scene, const Params& params) {
  for (int stage = 0; stage < kStageCount; ++stage) {
    const std::string name = "stage/" + std::string(stage_name(static_cast<Stage>(stage))) + "/" +
                             scene + "/" + precision_name(params.precision);
    benchmark::RegisterBenchmark(name.c_str(), measure_stage, params, static_cast<Stage>(stage))
        ->Unit(benchmark::kMicrosecond)
        ->UseManualTime();
  }
}

}  // namespace

void register_stages() {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params rigid = huddling(precision);
    rigid.deformation = 0;
    add("huddling", huddling(precision));
    add("dispersed", dispersed(precision));
    add("rigid", rigid);
  }
}

}  // namespace pupflow::bench
