#include "app/window/pup_values.h"

#include <map>
#include <utility>

namespace pupflow::window {
namespace {

template <class Value>
std::span<const Value> part_of(std::span<const Value> all, int pup, int per_pup) {
  if (all.empty()) return {};
  const auto count = static_cast<std::size_t>(per_pup);
  return all.subspan(static_cast<std::size_t>(pup) * count, count);
}

/// A litter of this pup alone. What it knows of others is lost.
struct Alone {
  std::vector<double> positions, velocities;
  LitterView view;

  Alone(const LitterView& litter, int pup) : view(litter) {
    const auto copied = [&](const PointVectors& vectors, std::vector<double>& xyz) {
      if (vectors.empty()) return PointVectors();
      xyz.resize(std::size_t{3} * static_cast<std::size_t>(litter.points));
      vectors.copy_pup_to(pup, xyz);
      return PointVectors(xyz, 1, litter.points);
    };
    view.pups = 1;
    view.positions = copied(litter.positions, positions);
    view.velocities = copied(litter.velocities, velocities);
    for (const auto of_pup :
         {&LitterView::tb, &LitterView::felt_tb, &LitterView::heading, &LitterView::exposed,
          &LitterView::t_left, &LitterView::t_right, &LitterView::turn}) {
      view.*of_pup = part_of(litter.*of_pup, pup, 1);
    }
    view.pose = part_of(litter.pose, pup, 1);
    view.left = part_of(litter.left, pup, litter.points);
    view.strain = part_of(litter.strain, pup, litter.points);
    view.touched = {};
    view.touching = {};
  }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;
};

bool reads_others(const LitterField& field) {
  return field.parts.has(Part::owners) || field.parts.has(Part::pairs);
}

}  // namespace

std::vector<double> values_of(const LitterField& field, const LitterView& litter, int pup) {
  if (!reads_others(field)) return field.values(Alone(litter, pup).view);
  const std::vector<double> all = field.values(litter);
  const auto own = part_of(std::span(all), pup, field.of_afferents ? litter.points : 1);
  return {own.begin(), own.end()};
}

std::vector<Touch> touched_by(const LitterView& litter, int pup) {
  std::map<int, int> points;
  for (const TouchingPair& pair : litter.touching) {
    if (pair.first == pup) points[pair.second] += 0;
    if (pair.second == pup) points[pair.first] += 0;
  }
  for (const int other : part_of(litter.touched, pup, litter.points)) {
    if (other >= 0) ++points[other];
  }
  std::vector<Touch> touches;
  for (const auto& [other, count] : points) touches.push_back({other, count});
  return touches;
}

void PupCurves::add(const LitterView& litter, int pup) {
  if (pup_ != pup) samples_.clear();
  pup_ = pup;
  while (!samples_.empty() && samples_.back().step >= litter.step) samples_.pop_back();
  if (samples_.empty()) gap_ = 1;
  const std::size_t size = samples_.size();
  if (size > 1 && samples_[size - 1].step - samples_[size - 2].step < gap_) samples_.pop_back();
  Sample& sample = samples_.emplace_back(Sample{litter.step, litter.time, {}});
  for (const LitterField& field : pup_fields()) {
    sample.values.push_back(values_of(field, litter, pup).front());
  }
  if (samples_.size() > kSamples) thin_out();
}

/// The first one stays, and the last one.
void PupCurves::thin_out() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 1 < samples_.size(); i += 2) {
    samples_[kept++] = std::move(samples_[i]);
  }
  samples_[kept++] = std::move(samples_.back());
  samples_.resize(kept);
  gap_ = 2 * (samples_.back().step - samples_.front().step) / static_cast<std::int64_t>(kSamples);
}

Watch recorded_for(const LitterField& map) {
  Watch watch{map.parts, map.velocities};
  for (const LitterField& field : pup_fields()) {
    watch.parts = watch.parts | field.parts;
    watch.velocities = watch.velocities || field.velocities;
  }
  return watch;
}

}  // namespace pupflow::window
