// What is measured on a litter: the observables of Wilson 2017 (Results) and their means over a
// run.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow {

/// The litter's observables after one step; NaN where one was not asked for.
struct Observables {
  double mean_tb = 0;   // mean body temperature
  double huddling = 0;  // 1 - A, mean over pups
  double groups = 0;    // connected components of the contact graph
  double largest = 0;   // pups in the largest of them
  // Pup flow: mean over pups of |A(t) - A(t - L h)| / (L h), per second, where L is the parameter
  // flow_lag. NaN before L steps have been seen.
  double flow = 0;
  double membership_flow = 0;  // pups whose set of group-mates changed in the step, per pup and s
};

enum class Observable { mean_tb, huddling, groups, largest, flow, membership_flow };
constexpr std::size_t kObservableCount = 6;

/// One row of the table of observables.
struct ObservableName {
  Observable observable;
  std::string_view name;  // of its column in every file
  double Observables::*value;
};

/// All observables, in the order of the enum and of the files' columns.
std::span<const ObservableName, kObservableCount> observable_names();

/// Some of the observables.
class ObservableSet {
 public:
  static ObservableSet all();
  ObservableSet& add(Observable observable);
  bool has(Observable observable) const { return (bits_ & bit(observable)) != 0; }

 private:
  static std::uint32_t bit(Observable observable) {
    return std::uint32_t{1} << static_cast<int>(observable);
  }
  std::uint32_t bits_ = 0;
};

/// Group of each pup: labels 0, 1, ... in the order of their lowest pup.
std::vector<int> group_labels(int pups, std::span<const TouchingPair> touching);

/// Watches one simulation step by step and computes what is wanted, nothing else. Keeps the
/// exposure of as many steps as the flow's lag, and the contacts of the step before.
class Observer {
 public:
  /// Flow and membership flow compare with the state as it is now, or a later one. The simulation
  /// must have been observed (Simulation::set_observed) in its last step and from here on. The lag
  /// is params().flow_lag, read once.
  explicit Observer(const Simulation& simulation, ObservableSet wanted = ObservableSet::all());

  /// The observables of the step just taken. Call this or `pass` once after every step.
  const Observables& observe(const Simulation& simulation);

  /// Nobody looks at the step just taken, but a later step may be compared with it.
  void pass(const Simulation& simulation);

  const Observables& last() const { return last_; }

 private:
  void remember(const Simulation& simulation);
  double flow(const Simulation& simulation) const;
  void look_at_groups(const Simulation& simulation);

  ObservableSet wanted_;
  std::size_t lag_;
  Observables last_;
  std::vector<std::vector<double>> exposed_;  // after state number i, from the first one seen, at
  std::size_t seen_ = 0;                      // i % lag_; the next one seen has number seen_
  std::vector<TouchingPair> touching_;        // of the last step
  std::vector<int> labels_;                   // its groups; empty while nobody asked for them
};

/// Means of a run over the steps after `discard`, as the rows of a sweep report them.
class RunMeans {
 public:
  explicit RunMeans(std::int64_t discard) : discard_(discard) {}

  /// Adds the observables after the step just taken, unless it is among the first `discard`.
  void add(const Simulation& simulation, const Observables& observables);

  std::int64_t count() const { return count_; }

  /// Means over the added steps; NaN when there are none. That of the flow is over the steps that
  /// have one: all but the first flow_lag - 1 that the observer sees.
  Observables means() const;

  /// Standard deviation of a pup's A over time, averaged over pups; NaN below two steps.
  double exposed_sd() const;

 private:
  std::int64_t discard_;
  std::int64_t count_ = 0, flow_count_ = 0;
  Observables sum_;
  std::vector<double> exposed_mean_, exposed_m2_;  // Welford's running moments, one per pup
};

}  // namespace pupflow
