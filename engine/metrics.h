// What is measured on a litter: the observables of Wilson 2017 (Results) and their means over a
// run.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulation.h"

namespace pupflow {

/// The litter's observables after one step.
struct Observables {
  double mean_tb = 0;          // mean body temperature
  double huddling = 0;         // 1 - A, mean over pups
  double groups = 0;           // connected components of the contact graph
  double largest = 0;          // pups in the largest of them
  double flow = 0;             // pup flow: mean over pups of |A(t) - A(t - h)| / h, per second
  double membership_flow = 0;  // pups whose set of group-mates changed, per pup and second
};

/// Group of each pup: labels 0, 1, ... in the order of their lowest pup.
std::vector<int> group_labels(int pups, std::span<const TouchingPair> touching);

/// Watches one simulation step by step. Keeps the exposure and the groups of the step before, from
/// which both flows are taken.
class Observer {
 public:
  explicit Observer(const Simulation& simulation);

  /// The observables of the step just taken; call it once after every step.
  const Observables& observe(const Simulation& simulation);
  const Observables& last() const { return last_; }

 private:
  Observables last_;
  std::vector<double> exposed_;
  std::vector<int> labels_;
};

/// Means of a run over the steps after `discard`, as the rows of a sweep report them.
class RunMeans {
 public:
  explicit RunMeans(std::int64_t discard) : discard_(discard) {}

  /// Adds the observables after the step just taken, unless it is among the first `discard`.
  void add(const Simulation& simulation, const Observables& observables);

  std::int64_t count() const { return count_; }

  /// Means over the added steps; NaN when there are none.
  Observables means() const;

  /// Standard deviation of a pup's A over time, averaged over pups; NaN below two steps.
  double exposed_sd() const;

 private:
  std::int64_t discard_;
  std::int64_t count_ = 0;
  Observables sum_;
  std::vector<double> exposed_mean_, exposed_m2_;  // Welford's running moments, one per pup
};

}  // namespace pupflow
