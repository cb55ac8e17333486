// Whole steps of the huddling litter: the baselines and the engine.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "bench/measure.h"
#include "bench/paper_manner.h"
#include "bench/plain_eigen.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kMeasuredSteps = 200;  // of the engine, in a round
constexpr int kBaselineStates = 8;   // of these steps, from which the baselines take a step each

/// States of the huddling litter over the steps on which the engine is measured.
std::vector<Snapshot> baseline_states(Precision precision) {
  Simulation simulation = settled(huddling(precision));
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
  const Simulation start = settled(huddling(precision));
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

Whole contenders() {
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

void print_whole_steps(const Whole& whole, const std::vector<std::vector<double>>& times) {
  std::printf("| whole step | µs | times as long as pupflow in double | in float | the result |\n");
  std::printf("|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::printf("| %s | %.1f | %.1f | %.1f | %s |\n", whole.contenders[i].name.c_str(),
                median(times[i]), ratio(times[i], times[kDouble]), ratio(times[i], times[kFloat]),
                whole.proof[i].c_str());
  }
}

}  // namespace

void whole_steps(int rounds, Verdicts& verdicts) {
  const Whole whole = contenders();
  const auto times = in_turns(whole.contenders, rounds);
  print_whole_steps(whole, times);
  const auto against = [&](Row slow, Row fast) { return ratio(times[slow], times[fast]); };
  verdicts.at_least("step in float against the paper's manner", 1000, against(kPaper, kFloat));
  verdicts.at_least("step in float against plain Eigen in double", 12, against(kEigen, kFloat));
  verdicts.at_least("step in double against the paper's manner", 600, against(kPaper, kDouble));
  verdicts.at_least("step in double against plain Eigen in double", 8, against(kEigen, kDouble));
}

}  // namespace pupflow::bench
