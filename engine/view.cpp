#include "pupflow/view.h"

#include <cassert>
#include <stdexcept>
#include <string>

namespace pupflow {
namespace {

void require_pup(int pup, int pups) {
  if (pup >= 0 && pup < pups) return;
  throw std::out_of_range("there is no pup " + std::to_string(pup) + " among " +
                          std::to_string(pups));
}

}  // namespace

PointVectors::PointVectors(std::span<const float> xyz, int pups, int points)
    : component_{xyz.data(), xyz.data() + 1, xyz.data() + 2},
      is_double_(false),
      pups_(pups),
      points_(points),
      step_(3),
      row_(3 * static_cast<std::ptrdiff_t>(points)) {
  assert(xyz.size() == 3 * static_cast<std::size_t>(pups) * static_cast<std::size_t>(points));
}

PointVectors::PointVectors(std::span<const double> xyz, int pups, int points)
    : component_{xyz.data(), xyz.data() + 1, xyz.data() + 2},
      pups_(pups),
      points_(points),
      step_(3),
      row_(3 * static_cast<std::ptrdiff_t>(points)) {
  assert(xyz.size() == 3 * static_cast<std::size_t>(pups) * static_cast<std::size_t>(points));
}

PointVectors::PointVectors(const float* x, const float* y, const float* z, int pups, int points,
                           int stride)
    : component_{x, y, z},
      is_double_(false),
      pups_(pups),
      points_(points),
      step_(1),
      row_(stride) {}

PointVectors::PointVectors(const double* x, const double* y, const double* z, int pups, int points,
                           int stride)
    : component_{x, y, z}, pups_(pups), points_(points), step_(1), row_(stride) {}

/// Calls `use(x, y, z)` for the points of pups first ... last - 1, in order.
template <class Real, class Use>
void PointVectors::for_each(int first, int last, const Use& use) const {
  const auto* x = static_cast<const Real*>(component_[0]);
  const auto* y = static_cast<const Real*>(component_[1]);
  const auto* z = static_cast<const Real*>(component_[2]);
  for (int pup = first; pup < last; ++pup) {
    std::ptrdiff_t at = pup * row_;
    for (int i = 0; i < points_; ++i, at += step_) use(x[at], y[at], z[at]);
  }
}

template <class Use>
void PointVectors::visit(int first, int last, const Use& use) const {
  is_double_ ? for_each<double>(first, last, use) : for_each<float>(first, last, use);
}

Eigen::Vector3d PointVectors::operator()(int pup, int point) const {
  assert(pup >= 0 && pup < pups_ && point >= 0 && point < points_);
  const std::ptrdiff_t at = pup * row_ + point * step_;
  Eigen::Vector3d vector;
  for (int axis = 0; axis < 3; ++axis) {
    vector[axis] = is_double_
                       ? static_cast<const double*>(component_[axis])[at]
                       : static_cast<double>(static_cast<const float*>(component_[axis])[at]);
  }
  return vector;
}

Eigen::Vector3d PointVectors::mean(int pup) const {
  require_pup(pup, pups_);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  visit(pup, pup + 1, [&](auto x, auto y, auto z) { sum += Eigen::Vector3d(x, y, z); });
  return sum / points_;
}

template <class Out>
void PointVectors::copy(int first, int last, std::span<Out> xyz) const {
  const std::size_t wanted =
      3 * static_cast<std::size_t>(last - first) * static_cast<std::size_t>(points_);
  if (xyz.size() != wanted) {
    throw std::invalid_argument("the span for vectors holds " + std::to_string(xyz.size()) +
                                " numbers, not " + std::to_string(wanted));
  }
  Out* out = xyz.data();
  visit(first, last, [&](auto x, auto y, auto z) {
    *out++ = static_cast<Out>(x);
    *out++ = static_cast<Out>(y);
    *out++ = static_cast<Out>(z);
  });
}

void PointVectors::copy_to(std::span<float> xyz) const {
  copy(0, pups_, xyz);
}
void PointVectors::copy_to(std::span<double> xyz) const {
  copy(0, pups_, xyz);
}
void PointVectors::copy_pup_to(int pup, std::span<float> xyz) const {
  require_pup(pup, pups_);
  copy(pup, pup + 1, xyz);
}
void PointVectors::copy_pup_to(int pup, std::span<double> xyz) const {
  require_pup(pup, pups_);
  copy(pup, pup + 1, xyz);
}

void LitterCopy::take(const LitterView& litter, bool velocities) {
  params_ = litter.params;
  recipe_ = litter.recipe;
  pups_ = litter.pups;
  points_ = litter.points;
  const auto copy = [](auto from, auto& to) { to.assign(from.begin(), from.end()); };
  const auto copy_vectors = [](const PointVectors& from, std::vector<float>& to) {
    to.resize(std::size_t{3} * static_cast<std::size_t>(from.pups()) *
              static_cast<std::size_t>(from.points()));
    from.copy_to(std::span<float>(to));
  };
  copy_vectors(litter.positions, positions_);
  copy_vectors(velocities ? litter.velocities : PointVectors(), velocities_);
  copy(litter.tb, tb_);
  copy(litter.felt_tb, felt_tb_);
  copy(litter.heading, heading_);
  copy(litter.exposed, exposed_);
  recorded_ = litter.recorded;
  const auto copy_recorded = [&](Part part, auto from, auto& to) {
    recorded_.has(part) ? copy(from, to) : to.clear();
  };
  copy_recorded(Part::sides, litter.t_left, t_left_);
  copy_recorded(Part::sides, litter.t_right, t_right_);
  copy_recorded(Part::sides, litter.turn, turn_);
  copy_recorded(Part::sides, litter.left, left_);
  copy_recorded(Part::pose, litter.pose, pose_);
  copy_recorded(Part::owners, litter.touched, touched_);
  copy_recorded(Part::strain, litter.strain, strain_);
  copy_recorded(Part::pairs, litter.touching, touching_);
  step_ = litter.step;
  time_ = litter.time;
}

LitterView LitterCopy::view() const {
  const PointVectors velocities =
      velocities_.empty() ? PointVectors()
                          : PointVectors(std::span<const float>(velocities_), pups_, points_);
  return {.params = params_,
          .recipe = recipe_,
          .pups = pups_,
          .points = points_,
          .positions = PointVectors(std::span<const float>(positions_), pups_, points_),
          .velocities = velocities,
          .tb = tb_,
          .felt_tb = felt_tb_,
          .heading = heading_,
          .exposed = exposed_,
          .t_left = t_left_,
          .t_right = t_right_,
          .turn = turn_,
          .pose = pose_,
          .touched = touched_,
          .left = left_,
          .strain = strain_,
          .touching = touching_,
          .step = step_,
          .time = time_,
          .recorded = recorded_};
}

}  // namespace pupflow
