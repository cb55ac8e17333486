// Whole steps: the baselines and the engine.
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

/// States of the litter over the steps on which the engine is measured.
std::vector<Snapshot> baseline_states(const Params& params) {
  Simulation simulation = settled(params);
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

/// The contenders of the huddling litter, in their order.
enum Row { kPaper, kPaperByElement, kPaperBounds, kEigen, kEigenFloat, kDouble, kFloat };

/// The contenders of other litters.
enum Few { kFewEigen, kFewDouble, kFewFloat };

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

void add_engine(Whole& whole, const std::string& name, const Params& params) {
  const Simulation start = settled(params);
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
  const Params in_double = huddling(Precision::double_), in_float = huddling(Precision::float_);
  const auto states = baseline_states(in_double);
  const auto float_states = baseline_states(in_float);
  Whole whole;
  add_baseline(whole, "paper's manner, all pairs, vectors", states, all_pairs);
  add_baseline(whole, "paper's manner, all pairs, by element", states, all_pairs_by_element);
  add_baseline(whole, "paper's manner, with bounds", states, with_bounds);
  add_baseline(whole, "plain Eigen, double", states, plain_eigen<double>);
  add_baseline(whole, "plain Eigen, float", float_states, plain_eigen<float>);
  add_engine(whole, "pupflow, double", in_double);
  add_engine(whole, "pupflow, float", in_float);
  return whole;
}

Whole few_contenders(double ambient_temperature) {
  const Params in_double = litter(ambient_temperature, Precision::double_);
  Whole whole;
  add_baseline(whole, "plain Eigen, double", baseline_states(in_double), plain_eigen<double>);
  add_engine(whole, "pupflow, double", in_double);
  add_engine(whole, "pupflow, float", litter(ambient_temperature, Precision::float_));
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

using Times = std::vector<double>;

/// A row of the second table.
void print_temperature(double ambient_temperature, const Times& eigen, const Times& in_double,
                       const Times& in_float, Verdicts& verdicts) {
  std::printf("| %.1f | %.1f | %.1f | %.1f | %.1f | %.1f |\n", ambient_temperature, median(eigen),
              median(in_double), ratio(eigen, in_double), median(in_float), ratio(eigen, in_float));
  const std::string at = " against plain Eigen in double, " + temperature_name(ambient_temperature);
  verdicts.measured("step in float" + at, ratio(eigen, in_float));
  verdicts.measured("step in double" + at, ratio(eigen, in_double));
}

}  // namespace

void whole_steps(int rounds, Verdicts& verdicts) {
  const Whole whole = contenders();
  const auto times = in_turns(whole.contenders, rounds);
  print_whole_steps(whole, times);
  const auto against = [&](Row slow, Row fast) { return ratio(times[slow], times[fast]); };
  verdicts.measured("step in float against the paper's manner", against(kPaper, kFloat));
  verdicts.measured("step in double against the paper's manner", against(kPaper, kDouble));
  std::printf(
      "\n| T_a | plain Eigen, double, µs | pupflow, double | through it | pupflow, float |"
      " through it |\n|---|---|---|---|---|---|\n");
  print_temperature(0.2, times[kEigen], times[kDouble], times[kFloat], verdicts);
  for (const double ta : {0.5, 0.8}) {
    const auto few = in_turns(few_contenders(ta).contenders, rounds);
    print_temperature(ta, few[kFewEigen], few[kFewDouble], few[kFewFloat], verdicts);
  }
}

}  // namespace pupflow::bench
