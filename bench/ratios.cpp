// pupflow_bench_ratios: the engine against the baselines, and stages against each other, measured
// in turns in one run on one thread. Prints Markdown tables. Says at the end which targets are
// reached; its exit status is 0 either way, since times are no test.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/measure.h"
#include "bench/paper_manner.h"
#include "bench/plain_eigen.h"
#include "bench/scenes.h"

namespace pupflow::bench {
namespace {

constexpr int kMeasuredSteps = 200;  // of the engine, a round
constexpr int kBaselineStates = 8;   // of these steps, from which the baselines take a step each

/// States of the huddling litter over the steps on which the engine is measured.
std::vector<Snapshot> baseline_states(Precision precision) {
  Simulation simulation = after(huddling(precision), kSettled);
  std::vector<Snapshot> states;
  for (int i = 0; i < kBaselineStates; ++i) {
    simulation.run(kMeasuredSteps / kBaselineStates);
    states.push_back(simulation.snapshot());
  }
  return states;
}

/// The median time of the second of two steps from each state.
template <class MakeBaseline>
double baseline_time(const std::vector<Snapshot>& states, MakeBaseline make) {
  std::vector<double> times;
  for (const Snapshot& state : states) {
    auto baseline = make(state);
    baseline.step();
    times.push_back(busy_microseconds([&] { baseline.step(); }));
  }
  return median(times);
}

/// The largest difference of a coordinate between a baseline's step and the engine's.
template <class MakeBaseline>
double disagreement(const Snapshot& state, MakeBaseline make) {
  auto baseline = make(state);
  baseline.step();
  Simulation simulation(state);
  simulation.step();
  const Snapshot expected = simulation.snapshot();
  const std::vector<double> positions = baseline.outcome().positions;
  double largest = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    largest = std::max(largest, std::abs(positions[i] - expected.positions[i]));
  }
  return largest;
}

PaperManner all_pairs(const Snapshot& s) {
  return {s, PairSearch::vectors};
}
PaperManner all_pairs_by_element(const Snapshot& s) {
  return {s, PairSearch::elements};
}
PaperManner with_bounds(const Snapshot& s) {
  return {s, PairSearch::bounds};
}
template <class Real>
PlainEigen<Real> plain_eigen(const Snapshot& s) {
  return PlainEigen<Real>(s);
}

/// The contenders of the first table, in its order.
enum Row { kPaper, kPaperByElement, kPaperBounds, kEigen, kEigenFloat, kDouble, kFloat };

struct Whole {
  std::vector<Contender> contenders;
  std::vector<std::string> proof;  // hash, or agreement with the engine
};

template <class MakeBaseline>
void add_baseline(Whole& whole, const std::string& name, const std::vector<Snapshot>& states,
                  MakeBaseline make) {
  char proof[64];
  std::snprintf(proof, sizeof proof, "a step differs from the engine's by at most %.0e",
                disagreement(states.front(), make));
  whole.contenders.push_back({name, [=] { return baseline_time(states, make); }});
  whole.proof.emplace_back(proof);
}

void add_engine(Whole& whole, const std::string& name, Precision precision) {
  const Simulation start = after(huddling(precision), kSettled);
  Simulation end = start;
  step_time(end, kMeasuredSteps);
  whole.contenders.push_back({name, [=] {
                                Simulation simulation = start;
                                const double time = step_time(simulation, kMeasuredSteps);
                                if (simulation.hash() != end.hash()) {
                                  throw std::runtime_error("the same steps gave another hash");
                                }
                                return time;
                              }});
  whole.proof.push_back("hash " + hash_text(end.hash()));
}

Whole whole_steps() {
  const auto states = baseline_states(Precision::double_);
  const auto float_states = baseline_states(Precision::float_);
  Whole whole;
  add_baseline(whole, "paper's manner, all pairs, vectors", states, all_pairs);
  add_baseline(whole, "paper's manner, all pairs, by element", states, all_pairs_by_element);
  add_baseline(whole, "paper's manner, with bounds", states, with_bounds);
  add_baseline(whole, "plain Eigen, double", states, plain_eigen<double>);
  add_baseline(whole, "plain Eigen, float", float_states, plain_eigen<float>);
  add_engine(whole, "pupflow, double", Precision::double_);
  add_engine(whole, "pupflow, float", Precision::float_);
  return whole;
}

void verdict(const char* what, double value, double target, bool at_least) {
  const bool reached = at_least ? value >= target : value <= target;
  std::printf("| %s | %s %.4g | %.4g | %s |\n", what, at_least ? "≥" : "≤", target, value,
              reached ? "reached" : "missed");
}

void print_whole_steps(const Whole& whole, const std::vector<std::vector<double>>& times) {
  std::printf("| whole step | µs | times as long as pupflow in double | in float | the result |\n");
  std::printf("|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::printf("| %s | %.1f | %.1f | %.1f | %s |\n", whole.contenders[i].name.c_str(),
                median(times[i]), ratio(times[i], times[kDouble]), ratio(times[i], times[kFloat]),
                whole.proof[i].c_str());
  }
}

/// The litters of the second table, in its order.
struct Scene {
  std::string name;
  Simulation start;
  std::vector<StageTimes> rounds;
  double stage(Stage stage) const {
    std::vector<double> times;
    for (const StageTimes& round : rounds) times.push_back(round[static_cast<std::size_t>(stage)]);
    return median(times);
  }
};

std::vector<Scene> stage_scenes() {
  std::vector<Scene> scenes;
  for (const Precision precision : {Precision::double_, Precision::float_}) {
    const std::string name = precision == Precision::double_ ? "double" : "float";
    Params rigid = huddling(precision);
    rigid.beta = 0;
    scenes.push_back({name + ", huddling", after(huddling(precision), kSettled), {}});
    scenes.push_back({name + ", dispersed", after(dispersed(precision), kSettled), {}});
    scenes.push_back({name + ", huddling, β = 0", after(rigid, kSettled), {}});
  }
  return scenes;
}

void measure_stages(std::vector<Scene>& scenes, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (Scene& scene : scenes) {
      Simulation simulation = scene.start;
      scene.rounds.push_back(stage_times(simulation, kMeasuredSteps));
    }
  }
}

void print_stages(const std::vector<Scene>& scenes) {
  std::printf("\n| µs a step |");
  for (int stage = 0; stage < kStageCount; ++stage) {
    std::printf(" %s |", std::string(stage_name(static_cast<Stage>(stage))).c_str());
  }
  std::printf("\n|---|");
  for (int stage = 0; stage < kStageCount; ++stage) std::printf("---|");
  std::printf("\n");
  for (const Scene& scene : scenes) {
    std::printf("| %s |", scene.name.c_str());
    for (int stage = 0; stage < kStageCount; ++stage) {
      std::printf(" %.2f |", scene.stage(static_cast<Stage>(stage)));
    }
    std::printf("\n");
  }
}

void print_verdicts(const std::vector<std::vector<double>>& times,
                    const std::vector<Scene>& scenes) {
  std::printf("\n| target | wanted | measured | |\n|---|---|---|---|\n");
  const auto against = [&](Row slow, Row fast) { return ratio(times[slow], times[fast]); };
  verdict("float against the paper's manner", against(kPaper, kFloat), 1000, true);
  verdict("float against plain Eigen (double)", against(kEigen, kFloat), 12, true);
  verdict("double against the paper's manner", against(kPaper, kDouble), 600, true);
  verdict("double against plain Eigen (double)", against(kEigen, kDouble), 8, true);
  for (std::size_t i = 0; i < scenes.size(); i += 3) {
    const std::string precision = scenes[i].name.substr(0, scenes[i].name.find(','));
    const auto through = [&](Stage stage, std::size_t other) {
      return scenes[i + other].stage(stage) / scenes[i].stage(stage);
    };
    verdict((precision + ": contacts, dispersed through huddling").c_str(),
            through(Stage::contact, 1), 0.2, false);
    verdict((precision + ": shape matching, β = 0 through β = 0.5").c_str(),
            through(Stage::shape_match, 2), 0.75, false);
  }
}

int run(int rounds) {
  const Whole whole = whole_steps();
  std::vector<Scene> scenes = stage_scenes();
  const auto times = in_turns(whole.contenders, rounds);
  measure_stages(scenes, rounds);
  print_whole_steps(whole, times);
  print_stages(scenes);
  print_verdicts(times, scenes);
  return 0;
}

}  // namespace
}  // namespace pupflow::bench

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  if (argc > 2 || rounds < 1) {
    std::fprintf(stderr, "usage: pupflow_bench_ratios [ROUNDS], at least one; default 15\n");
    return 2;
  }
  return pupflow::bench::run(rounds);
}
