#include "pupflow/observer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pupflow {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<ObservableName, kObservableCount> kNames{{
    {Observable::mean_tb, "mean_tb", &Observables::mean_tb},
    {Observable::huddling, "huddling", &Observables::huddling},
    {Observable::groups, "groups", &Observables::groups},
    {Observable::largest, "largest", &Observables::largest},
    {Observable::flow, "flow", &Observables::flow},
    {Observable::membership_flow, "membership_flow", &Observables::membership_flow},
}};

/// Root of `pup` in a union-find forest, halving the path on the way.
int find_root(std::vector<int>& parent, int pup) {
  while (parent[pup] != pup) pup = parent[pup] = parent[parent[pup]];
  return pup;
}

double mean(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Pups whose set of group-mates differs between two labellings. Labels are numbered by their
/// lowest pup, so equal sets are those whose members agree on first member and size and map one to
/// one.
int changed_memberships(const std::vector<int>& before, const std::vector<int>& now) {
  const auto pups = static_cast<int>(now.size());
  // A group of now is unchanged when all its members were in one group before, which had its size.
  std::vector<int> size_before(pups, 0), size_now(pups, 0), origin(pups, -1);
  std::vector<bool> mixed(pups, false);
  for (int i = 0; i < pups; ++i) {
    ++size_before[before[i]];
    ++size_now[now[i]];
    int& from = origin[now[i]];
    if (from < 0) from = before[i];
    if (from != before[i]) mixed[now[i]] = true;
  }
  int changed = 0;
  for (int i = 0; i < pups; ++i) {
    const int group = now[i];
    if (mixed[group] || size_before[origin[group]] != size_now[group]) ++changed;
  }
  return changed;
}

}  // namespace

std::vector<int> group_labels(int pups, std::span<const TouchingPair> touching) {
  std::vector<int> parent(pups);
  std::iota(parent.begin(), parent.end(), 0);
  for (const TouchingPair& pair : touching) {
    const int a = find_root(parent, pair.first), b = find_root(parent, pair.second);
    parent[std::max(a, b)] = std::min(a, b);  // so a root is its group's lowest pup
  }
  std::vector<int> label(pups);
  int next = 0;
  for (int pup = 0; pup < pups; ++pup) {
    const int root = find_root(parent, pup);
    label[pup] = root == pup ? next++ : label[root];
  }
  return label;
}

std::span<const ObservableName, kObservableCount> observable_names() {
  return kNames;
}

ObservableSet ObservableSet::all() {
  ObservableSet set;
  for (const ObservableName& row : kNames) set.add(row.observable);
  return set;
}

ObservableSet& ObservableSet::add(Observable observable) {
  bits_ |= bit(observable);
  return *this;
}

Observer::Observer(const Simulation& simulation, ObservableSet wanted)
    : wanted_(wanted), lag_(static_cast<std::size_t>(simulation.params().flow_lag)) {
  remember(simulation);
}

void Observer::remember(const Simulation& simulation) {
  if (wanted_.has(Observable::flow)) {
    if (exposed_.size() < lag_) exposed_.emplace_back();
    exposed_[seen_++ % lag_].assign(simulation.exposed().begin(), simulation.exposed().end());
  }
  if (wanted_.has(Observable::membership_flow))
    touching_.assign(simulation.touching().begin(), simulation.touching().end());
}

void Observer::pass(const Simulation& simulation) {
  remember(simulation);
  labels_.clear();
}

double Observer::flow(const Simulation& simulation) const {
  if (seen_ < lag_) return kNothing;
  const std::span<const double> now = simulation.exposed();
  const std::vector<double>& then = exposed_[seen_ % lag_];
  double change = 0;
  for (std::size_t pup = 0; pup < now.size(); ++pup) change += std::abs(now[pup] - then[pup]);
  return change / static_cast<double>(now.size()) /
         (static_cast<double>(lag_) * simulation.params().dt);
}

void Observer::look_at_groups(const Simulation& simulation) {
  const int pups = simulation.pups();
  std::vector<int> labels = group_labels(pups, simulation.touching());
  if (wanted_.has(Observable::groups))
    last_.groups = 1 + *std::max_element(labels.begin(), labels.end());
  if (wanted_.has(Observable::largest)) {
    std::vector<int> size(pups, 0);
    for (const int label : labels) ++size[label];
    last_.largest = *std::max_element(size.begin(), size.end());
  }
  if (wanted_.has(Observable::membership_flow)) {
    if (labels_.empty()) labels_ = group_labels(pups, touching_);
    last_.membership_flow = changed_memberships(labels_, labels) / (pups * simulation.params().dt);
  }
  labels_ = std::move(labels);
}

const Observables& Observer::observe(const Simulation& simulation) {
  for (const ObservableName& row : kNames)
    last_.*row.value = wanted_.has(row.observable) ? 0 : kNothing;
  if (simulation.pups() == 0) return last_;
  if (wanted_.has(Observable::mean_tb)) last_.mean_tb = mean(simulation.body_temperature());
  if (wanted_.has(Observable::huddling)) last_.huddling = 1 - mean(simulation.exposed());
  if (wanted_.has(Observable::flow)) last_.flow = flow(simulation);
  if (wanted_.has(Observable::groups) || wanted_.has(Observable::largest) ||
      wanted_.has(Observable::membership_flow)) {
    look_at_groups(simulation);
  }
  remember(simulation);
  return last_;
}

void RunMeans::add(const Simulation& simulation, const Observables& observables) {
  if (simulation.steps_done() <= discard_) return;
  const std::span<const double> exposed = simulation.exposed();
  exposed_mean_.resize(exposed.size(), 0);
  exposed_m2_.resize(exposed.size(), 0);
  ++count_;
  for (std::size_t pup = 0; pup < exposed.size(); ++pup) {
    const double delta = exposed[pup] - exposed_mean_[pup];
    exposed_mean_[pup] += delta / static_cast<double>(count_);
    exposed_m2_[pup] += delta * (exposed[pup] - exposed_mean_[pup]);
  }
  const bool has_flow = !std::isnan(observables.flow);
  flow_count_ += has_flow ? 1 : 0;
  for (const ObservableName& row : kNames) {
    if (row.observable != Observable::flow || has_flow) sum_.*row.value += observables.*row.value;
  }
}

Observables RunMeans::means() const {
  Observables means;
  for (const ObservableName& row : kNames) {
    const std::int64_t count = row.observable == Observable::flow ? flow_count_ : count_;
    means.*row.value = count > 0 ? sum_.*row.value / static_cast<double>(count) : kNothing;
  }
  return means;
}

double RunMeans::exposed_sd() const {
  if (count_ < 2) return kNothing;
  if (exposed_m2_.empty()) return 0;
  double sum = 0;
  for (const double m2 : exposed_m2_) sum += std::sqrt(m2 / static_cast<double>(count_ - 1));
  return sum / static_cast<double>(exposed_m2_.size());
}

}  // namespace pupflow
