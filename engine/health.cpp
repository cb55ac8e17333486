#include "engine/health.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace pupflow {
namespace {

template <class Real>
Eigen::Vector3d position(const State<Real>& state, int pup, int point) {
  const std::size_t k = state.row(pup) + point;
  return {state.x[k], state.y[k], state.z[k]};
}

/// Distance from the arena's axis to the nearest point of a box.
template <class Real>
double distance_from_axis(const Bounds<Real>& box) {
  const auto away = [&](int axis) {
    const double low = box.low[axis], high = box.high[axis];
    return std::max({low, -high, 0.0});
  };
  return std::hypot(away(0), away(1));
}

}  // namespace

template <class Real>
Status find_non_finite(const State<Real>& state, int pup, Stage stage) {
  for (int i = 0; i < state.points; ++i) {
    const std::size_t k = state.row(pup) + i;
    const bool moving =
        std::isfinite(state.vx[k]) && std::isfinite(state.vy[k]) && std::isfinite(state.vz[k]);
    if (!position(state, pup, i).allFinite() || !moving) {
      return {Status::Kind::non_finite, stage, state.step + 1, pup, i};
    }
  }
  return {};
}

template <class Real>
Status inspect_pup(const State<Real>& state, int pup, double pup_radius, Stage stage) {
  const Status finite = find_non_finite(state, pup, stage);
  if (!finite.ok()) return finite;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (int i = 0; i < state.points; ++i) centre += position(state, pup, i) / state.points;
  for (int i = 0; i < state.points; ++i) {
    const double distance = (position(state, pup, i) - centre).stableNorm();
    if (!(distance <= kDivergedRadii * pup_radius)) {
      return {Status::Kind::diverged, stage, state.step + 1, pup, i};
    }
  }
  return {};
}

template <class Real>
Status check_motion(const Params& params, State<Real>& state, int pup, Stage stage) {
  const double suspect = kSuspectRadii * params.pup_radius;
  bool sound = update_bounds(state, pup);
  const Bounds<Real>& box = state.bounds[pup];
  for (int axis = 0; axis < 3; ++axis) {
    sound =
        sound && static_cast<double>(box.high[axis]) - static_cast<double>(box.low[axis]) < suspect;
  }
  if (!sound) {
    const Status status = inspect_pup(state, pup, params.pup_radius, stage);
    if (!status.ok()) return status;
  }
  if (distance_from_axis(box) > params.arena_radius + kDivergedRadii * params.pup_radius) {
    return {Status::Kind::escaped, stage, state.step + 1, pup, -1};
  }
  return {};
}

template Status find_non_finite<float>(const State<float>&, int, Stage);
template Status find_non_finite<double>(const State<double>&, int, Stage);
template Status check_motion<float>(const Params&, State<float>&, int, Stage);
template Status check_motion<double>(const Params&, State<double>&, int, Stage);
template Status inspect_pup<float>(const State<float>&, int, double, Stage);
template Status inspect_pup<double>(const State<double>&, int, double, Stage);

}  // namespace pupflow
