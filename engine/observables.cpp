// The table of observables, and their formulas (Wilson 2017, Results).
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/observation.h"
#include "pupflow/fields.h"

namespace pupflow {
namespace {

double mean(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double mean_tb(const Observation& o) {
  return mean(o.litter.tb);
}

double huddling(const Observation& o) {
  return 1 - mean(o.litter.exposed);
}

double groups(const Observation& o) {
  return static_cast<double>(o.group_sizes.size());
}

double largest(const Observation& o) {
  return *std::max_element(o.group_sizes.begin(), o.group_sizes.end());
}

double flow(const Observation& o) {
  if (o.exposed_before.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::span<const double> now = o.litter.exposed;
  double change = 0;
  for (std::size_t pup = 0; pup < now.size(); ++pup) {
    change += std::abs(now[pup] - o.exposed_before[pup]);
  }
  return change / static_cast<double>(now.size()) /
         (static_cast<double>(o.lag) * o.litter.params.dt);
}

/// Labels are numbered by their lowest pup, so a group of now is unchanged when all its members
/// were in one group before, which had its size.
double membership_flow(const Observation& o) {
  const std::span<const int> before = o.labels_before, now = o.labels;
  const std::size_t pups = now.size();
  std::vector<int> size_before(pups, 0), origin(pups, -1);
  std::vector<bool> mixed(pups, false);
  for (std::size_t i = 0; i < pups; ++i) {
    ++size_before[before[i]];
    int& from = origin[now[i]];
    if (from < 0) from = before[i];
    if (from != before[i]) mixed[now[i]] = true;
  }
  int changed = 0;
  for (const int group : now) {
    if (mixed[group] || size_before[origin[group]] != o.group_sizes[group]) ++changed;
  }
  return changed / (o.litter.pups * o.litter.params.dt);
}

constexpr std::array<ObservableField, kObservableCount> kObservables{{
    {{.name = "mean_tb",
      .symbol = "T_b",
      .label = "body temperature T_b",
      .equation = "mean over pups of T_b",
      .doc = "Mean body temperature of the pups.",
      .low = 0.4,
      .high = 0.8},
     Observable::mean_tb,
     &Observables::mean_tb,
     mean_tb},
    {{.name = "huddling",
      .symbol = "1 − A",
      .label = "huddling 1 − A",
      .equation = "1 − mean over pups of A",
      .doc = "Share of a pup's points that touch another pup, mean over pups.",
      .low = 0,
      .high = 0.5,
      .parts = {Part::exposure}},
     Observable::huddling,
     &Observables::huddling,
     huddling},
    {{.name = "groups",
      .label = "groups",
      .equation = "connected components of the contact graph",
      .doc = "Groups of pups that touch, directly or through others; a pup alone is one.",
      .low = 0,
      .high = 4,
      .digits = 0,
      .parts = {Part::pairs}},
     Observable::groups,
     &Observables::groups,
     groups},
    {{.name = "largest",
      .label = "largest group",
      .unit = "pups",
      .equation = "pups in the largest component",
      .doc = "Pups in the largest group.",
      .low = 0,
      .high = 4,
      .digits = 0,
      .parts = {Part::pairs}},
     Observable::largest,
     &Observables::largest,
     largest},
    {{.name = "flow",
      .label = "pup flow",
      .unit = "1/s",
      .equation = "mean over pups of |A(t) − A(t − L h)| / (L h), L = flow_lag",
      .doc = "How fast pups are buried and exposed; not known before flow_lag steps.",
      .low = 0,
      .high = 0.5,
      .parts = {Part::exposure}},
     Observable::flow,
     &Observables::flow,
     flow},
    {{.name = "membership_flow",
      .label = "membership flow",
      .unit = "1/s",
      .equation = "pups whose set of group-mates changed in the step / (N h)",
      .doc = "Pups whose set of group-mates changed, per pup and second.",
      .low = 0,
      .high = 1,
      .parts = {Part::pairs}},
     Observable::membership_flow,
     &Observables::membership_flow,
     membership_flow},
}};

}  // namespace

std::span<const ObservableField, kObservableCount> observables() {
  return kObservables;
}

}  // namespace pupflow
