#include "app/window/history.h"

namespace pupflow::window {
namespace {

constexpr std::array<ObservableRow, kObservableCount> kRows{{
    {"mean_tb", "body temperature T_b", "", "Mean body temperature of the pups.",
     &Observables::mean_tb, 3, 0.4, 0.8},
    {"huddling", "huddling 1 - A", "", "Share of a pup's points that touch another pup, mean.",
     &Observables::huddling, 3, 0, 0.5},
    {"groups", "groups", "", "Huddles: connected components of who touches whom.",
     &Observables::groups, 0, 0, 4},
    {"largest", "largest group", "pups", "Pups in the largest group.", &Observables::largest, 0, 0,
     4},
    {"flow", "pup flow", "1/s",
     "Mean over pups of |A(t) - A(t - h)| / h: how fast pups are buried "
     "and exposed.",
     &Observables::flow, 3, 0, 0.5},
    {"membership_flow", "membership flow", "1/s",
     "Pups whose set of group-mates changed, per pup and second.", &Observables::membership_flow, 3,
     0, 1},
}};

}  // namespace

std::span<const ObservableRow, kObservableCount> observable_rows() {
  return kRows;
}

void History::add(double time, const Observables& observables) {
  for (std::size_t k = 0; k < kObservableCount; ++k) sums_[k] += observables.*kRows[k].value;
  if (++summed_ < kStepsPerSample) return;
  if (size_ == kSamples) {
    first_ = slot(1);
  } else {
    ++size_;
  }
  const auto last = static_cast<std::size_t>(slot(size_ - 1));
  for (std::size_t k = 0; k < kObservableCount; ++k) {
    values_[k][last] = static_cast<float>(sums_[k] / kStepsPerSample);
  }
  times_[last] = time;
  sums_ = {};
  summed_ = 0;
}

}  // namespace pupflow::window
