#include "engine/health.h"

#include <Eigen/Core>
#include <cmath>

namespace pupflow {

template <class Real>
Status inspect_pup(const State<Real>& state, int pup, double pup_radius, Stage stage) {
  const std::size_t row = state.row(pup);
  const auto position = [&](int i) {
    return Eigen::Vector3d(state.x[row + i], state.y[row + i], state.z[row + i]);
  };
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (int i = 0; i < state.points; ++i) {
    const std::size_t k = row + i;
    const bool moving =
        std::isfinite(state.vx[k]) && std::isfinite(state.vy[k]) && std::isfinite(state.vz[k]);
    if (!position(i).allFinite() || !moving) {
      return {Status::Kind::non_finite, stage, state.step + 1, pup, i};
    }
    centre += position(i) / state.points;
  }
  for (int i = 0; i < state.points; ++i) {
    const double distance = (position(i) - centre).stableNorm();
    if (!(distance <= kDivergedRadii * pup_radius)) {
      return {Status::Kind::diverged, stage, state.step + 1, pup, i};
    }
  }
  return {};
}

template Status inspect_pup<float>(const State<float>&, int, double, Stage);
template Status inspect_pup<double>(const State<double>&, int, double, Stage);

}  // namespace pupflow
