#include "engine/boundary.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/invariants.h"
#include "engine/point_set.h"

namespace pupflow {
namespace {

template <class Real>
bool reaches_wall(Real x, Real y, Real r, Real arena_squared) {
  const Real dx = std::abs(x) + r, dy = std::abs(y) + r;
  return dx * dx + dy * dy > arena_squared;
}

template <class Real>
void push_from_wall(Real h, std::size_t i, State<Real>& s) {
  const Real distance = std::sqrt(s.x[i] * s.x[i] + s.y[i] * s.y[i]);
  const Real wx = distance > 0 ? -s.x[i] / distance : Real(-1);  // atan2(0, 0) = 0
  const Real wy = distance > 0 ? -s.y[i] / distance : Real(0);
  s.vx[i] = (s.vx[i] + wx) / 2;
  s.vy[i] = (s.vy[i] + wy) / 2;
  s.vz[i] = s.vz[i] / 2;
  s.x[i] += h * s.vx[i];
  s.y[i] += h * s.vy[i];
  s.z[i] += h * s.vz[i];
}

}  // namespace

template <class Real>
void apply_boundaries(const Params& params, State<Real>& state, int pup) {
  assert(pup >= 0 && pup < state.pups);
  assert(is_enclosed(state, pup));
  const auto r = static_cast<Real>(params.point_radius);
  const auto h = static_cast<Real>(params.dt);
  const auto arena = static_cast<Real>(params.arena_radius);
  Bounds<Real>& box = state.bounds[pup];
  const std::size_t row = state.row(pup);
  if (box.low[2] < r) {
    state.kernels->floor(r, state.stride, state.z.data() + row, state.vz.data() + row);
    if (box.centre[2] > r) {
      box.low[2] = r;  // the points moved towards the centre, so the ball still encloses them
    } else {
      update_bounds(state, pup);
    }
  }
  const Real far_x = std::max(std::abs(box.low[0]), std::abs(box.high[0]));
  const Real far_y = std::max(std::abs(box.low[1]), std::abs(box.high[1]));
  if (!reaches_wall(far_x, far_y, r, arena * arena)) return;
  std::uint64_t reaching[kMaxPointWords];
  const bool any = state.kernels->wall(state.x.data() + row, state.y.data() + row, state.points, r,
                                       arena * arena, reaching);
  if (!any) return;
  for_each_point(reaching, words_for(state.points),
                 [&](int i) { push_from_wall(h, row + i, state); });
  update_bounds(state, pup);
}

template void apply_boundaries<float>(const Params&, State<float>&, int);
template void apply_boundaries<double>(const Params&, State<double>&, int);

}  // namespace pupflow
