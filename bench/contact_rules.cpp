// The contact stage by rule, on the same positions.
#include <cstdio>

#include "bench/litter_state.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "engine/boundary.h"
#include "engine/contact.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kStates = 8, kStepsBetween = 25;  // of a litter, as in whole_steps.cpp
constexpr double kTemperatures[] = {0.2, 0.5, 0.8};
constexpr int kRepeats = 15;  // of the stage from each state

/// The litter of `params` as the contact stage finds it in some of its steps.
template <class Real>
std::vector<State<Real>> states_before_contacts(const Params& params) {
  Simulation simulation = settled(params);
  std::vector<State<Real>> states;
  for (int i = 0; i < kStates; ++i) {
    simulation.run(kStepsBetween);
    State<Real>& state = states.emplace_back(state_of<Real>(simulation.snapshot()));
    for (int pup = 0; pup < state.pups; ++pup) apply_boundaries(params, state, pup);
  }
  return states;
}

/// Microseconds of the contact stage by `rule`: the mean over `states` of medians.
template <class Real>
double stage_time(const std::vector<State<Real>>& states, Params params, ContactRule rule) {
  params.contact = rule;
  Contacts<Real> contacts;
  Team team;
  State<Real> state;
  double sum = 0;
  for (const State<Real>& start : states) {
    std::vector<double> times;
    for (int i = 0; i < kRepeats; ++i) {
      state = start;
      times.push_back(microseconds([&] {
        contacts.find(params, {}, state, team);
        for (int pup = 0; pup < state.pups; ++pup) contacts.apply(params, 1, state, pup, 0);
      }));
    }
    sum += median(times);
  }
  return sum / static_cast<double>(states.size());
}

template <class Real>
void compare_rules(const Params& params, int rounds, Verdicts& verdicts) {
  const auto states = states_before_contacts<Real>(params);
  const auto by = [&](ContactRule rule) {
    return [&, rule] { return stage_time(states, params, rule); };
  };
  const auto times = in_turns({{"nearest", by(ContactRule::nearest)},
                               {"mean", by(ContactRule::mean)},
                               {"sum", by(ContactRule::sum)}},
                              3 * rounds);
  const std::string precision = precision_name(params.precision);
  const std::string at = temperature_name(params.ambient_temperature);
  std::printf("| %s, %s | %.1f | %.1f | %.1f | %.2f | %.2f |\n", precision.c_str(), at.c_str(),
              median(times[0]), median(times[1]), median(times[2]), ratio(times[1], times[0]),
              ratio(times[2], times[0]));
  verdicts.measured("contacts, sum through nearest, " + at + ", in " + precision,
                    ratio(times[2], times[0]));
}

}  // namespace

void contact_rules(int rounds, Verdicts& verdicts) {
  std::printf(
      "| contact stage, µs | nearest | mean | sum | mean through nearest |"
      " sum through nearest |\n|---|---|---|---|---|---|\n");
  for (const double ta : kTemperatures) {
    compare_rules<float>(litter(ta, Precision::float_), rounds, verdicts);
  }
  for (const double ta : kTemperatures) {
    compare_rules<double>(litter(ta, Precision::double_), rounds, verdicts);
  }
}

}  // namespace pupflow::bench
