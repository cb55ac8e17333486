#include "engine/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pupflow {
namespace {

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

Observer::Observer(const Simulation& simulation)
    : exposed_(simulation.exposed().begin(), simulation.exposed().end()),
      labels_(group_labels(simulation.pups(), simulation.touching())) {}

const Observables& Observer::observe(const Simulation& simulation) {
  const int pups = simulation.pups();
  const std::span<const double> exposed = simulation.exposed();
  const std::vector<int> labels = group_labels(pups, simulation.touching());
  last_ = {};
  if (pups == 0) return last_;
  last_.mean_tb = mean(simulation.body_temperature());
  last_.huddling = 1 - mean(exposed);
  std::vector<int> size(pups, 0);
  for (const int label : labels) ++size[label];
  last_.groups = 1 + *std::max_element(labels.begin(), labels.end());
  last_.largest = *std::max_element(size.begin(), size.end());
  const double dt = simulation.params().dt;
  double change = 0;
  for (int pup = 0; pup < pups; ++pup) change += std::abs(exposed[pup] - exposed_[pup]);
  last_.flow = change / pups / dt;
  last_.membership_flow = changed_memberships(labels_, labels) / (pups * dt);
  exposed_.assign(exposed.begin(), exposed.end());
  labels_ = labels;
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
  sum_.mean_tb += observables.mean_tb;
  sum_.huddling += observables.huddling;
  sum_.groups += observables.groups;
  sum_.largest += observables.largest;
  sum_.flow += observables.flow;
  sum_.membership_flow += observables.membership_flow;
}

Observables RunMeans::means() const {
  const double n =
      count_ > 0 ? static_cast<double>(count_) : std::numeric_limits<double>::quiet_NaN();
  return {sum_.mean_tb / n, sum_.huddling / n, sum_.groups / n,
          sum_.largest / n, sum_.flow / n,     sum_.membership_flow / n};
}

double RunMeans::exposed_sd() const {
  if (count_ < 2) return std::numeric_limits<double>::quiet_NaN();
  if (exposed_m2_.empty()) return 0;
  double sum = 0;
  for (const double m2 : exposed_m2_) sum += std::sqrt(m2 / static_cast<double>(count_ - 1));
  return sum / static_cast<double>(exposed_m2_.size());
}

}  // namespace pupflow
