/// @file
/// What is measured on a litter: the observables of Wilson 2017 (Results) and their means over a
/// run.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pupflow/fields.h"
#include "pupflow/view.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// Some of the observables.
class ObservableSet {
 public:
  /// All observables.
  static ObservableSet all();

  /// Adds one, and returns this set.
  ObservableSet& add(Observable observable);

  /// Whether it has this one.
  bool has(Observable observable) const { return (bits_ & bit(observable)) != 0; }

  /// What steps must record for them (Simulation::set_observed).
  PartSet parts() const;

 private:
  static std::uint32_t bit(Observable observable) {
    return std::uint32_t{1} << static_cast<int>(observable);
  }
  std::uint32_t bits_ = 0;
};

/// Watches one simulation step by step and computes what is wanted, nothing else. Keeps the
/// exposure of as many steps as the flow's lag, and the contacts of the step before.
class Observer {
 public:
  /// Flow and membership flow compare with the state as it is now, or a later one. The last step
  /// must have recorded `wanted.parts()` (Simulation::set_observed), and so must all from here on.
  /// The lag is params.flow_lag, read once.
  explicit Observer(const LitterView& litter, ObservableSet wanted = ObservableSet::all());

  /// The observables of the step just taken. Call this or `pass` once after every step.
  const Observables& observe(const LitterView& litter);

  /// Nobody looks at the step just taken, but a later step may be compared with it.
  void pass(const LitterView& litter);

  /// What `observe` returned last; zeros before its first call.
  const Observables& last() const { return last_; }

 private:
  void remember(const LitterView& litter);

  ObservableSet wanted_;
  std::size_t lag_;
  Observables last_;
  std::vector<std::vector<double>> exposed_;  // after state number i, from the first one seen, at
  std::size_t seen_ = 0;                      // i % lag_; the next one seen has number seen_
  std::vector<TouchingPair> touching_;        // of the last step
  std::vector<int> labels_;                   // its groups; empty while nobody asked for them
};

/// What a whole run comes to: means of the observables, in their order, then the standard deviation
/// of a pup's A over time, mean over pups.
///@{
constexpr std::size_t kRunStatisticCount = kObservableCount + 1;
std::span<const Field, kRunStatisticCount> run_statistics();
///@}

/// The place of an observable's mean among them.
constexpr std::size_t statistic_of(Observable observable) {
  return static_cast<std::size_t>(observable);
}

/// The place of the standard deviation of A among them.
constexpr std::size_t kExposedSd = kObservableCount;

/// Means of a run over the steps after `discard`, as the rows of a sweep report them.
class RunMeans {
 public:
  /// Leaves out the first `discard` steps.
  explicit RunMeans(std::int64_t discard) : discard_(discard) {}

  /// Adds what was seen after the step just taken, unless it is among the first `discard`.
  void add(const LitterView& litter, const Observables& seen);

  /// How many steps were added.
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
#pragma GCC visibility pop
