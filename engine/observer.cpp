#include "pupflow/observer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engine/observation.h"

namespace pupflow {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

constexpr Field kExposedSdField{
    .name = "exposed_sd",
    .symbol = "sd(A)",
    .label = "standard deviation of A over time",
    .equation = "mean over pups of the standard deviation of A over the steps of the means",
    .doc = "How much a pup's exposed share varies in time; the paper's pup flow (Fig. 2).",
    .low = 0,
    .parts = {Part::exposure}};

std::array<Field, kRunStatisticCount> make_run_statistics() {
  std::array<Field, kRunStatisticCount> fields;
  std::copy(observables().begin(), observables().end(), fields.begin());
  fields[kExposedSd] = kExposedSdField;
  return fields;
}

}  // namespace

std::span<const Field, kRunStatisticCount> run_statistics() {
  static const std::array<Field, kRunStatisticCount> fields = make_run_statistics();
  return fields;
}

ObservableSet ObservableSet::all() {
  ObservableSet set;
  for (const ObservableField& row : observables()) set.add(row.observable);
  return set;
}

ObservableSet& ObservableSet::add(Observable observable) {
  bits_ |= bit(observable);
  return *this;
}

PartSet ObservableSet::parts() const {
  PartSet parts;
  for (const ObservableField& row : observables()) {
    if (has(row.observable)) parts = parts | row.parts;
  }
  return parts;
}

Observer::Observer(const LitterView& litter, ObservableSet wanted)
    : wanted_(wanted), lag_(static_cast<std::size_t>(litter.params.flow_lag)) {
  remember(litter);
}

void Observer::remember(const LitterView& litter) {
  if (wanted_.has(Observable::flow)) {
    if (exposed_.size() < lag_) exposed_.emplace_back();
    exposed_[seen_++ % lag_].assign(litter.exposed.begin(), litter.exposed.end());
  }
  if (wanted_.has(Observable::membership_flow))
    touching_.assign(litter.touching.begin(), litter.touching.end());
}

void Observer::pass(const LitterView& litter) {
  remember(litter);
  labels_.clear();
}

const Observables& Observer::observe(const LitterView& litter) {
  const bool membership = wanted_.has(Observable::membership_flow);
  std::vector<int> labels, sizes;
  if (wanted_.parts().has(Part::pairs)) {
    labels = group_labels(litter.pups, litter.touching);
    sizes = group_sizes(labels);
    if (membership && labels_.empty()) labels_ = group_labels(litter.pups, touching_);
  }
  std::span<const double> exposed_before;
  if (wanted_.has(Observable::flow) && seen_ >= lag_) exposed_before = exposed_[seen_ % lag_];
  const Observation observation{litter, lag_, exposed_before, labels_, labels, sizes};
  for (const ObservableField& row : observables()) {
    last_.*row.value = !wanted_.has(row.observable) ? kNothing
                       : litter.pups == 0           ? 0
                                                    : row.formula(observation);
  }
  labels_ = std::move(labels);
  if (litter.pups > 0) remember(litter);
  return last_;
}

void RunMeans::add(const LitterView& litter, const Observables& seen) {
  if (litter.step <= discard_) return;
  const std::span<const double> exposed = litter.exposed;
  exposed_mean_.resize(exposed.size(), 0);
  exposed_m2_.resize(exposed.size(), 0);
  ++count_;
  for (std::size_t pup = 0; pup < exposed.size(); ++pup) {
    const double delta = exposed[pup] - exposed_mean_[pup];
    exposed_mean_[pup] += delta / static_cast<double>(count_);
    exposed_m2_[pup] += delta * (exposed[pup] - exposed_mean_[pup]);
  }
  const bool has_flow = !std::isnan(seen.flow);
  flow_count_ += has_flow ? 1 : 0;
  for (const ObservableField& row : observables()) {
    if (row.observable != Observable::flow || has_flow) sum_.*row.value += seen.*row.value;
  }
}

Observables RunMeans::means() const {
  Observables means;
  for (const ObservableField& row : observables()) {
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
