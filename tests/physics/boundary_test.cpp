// Floor and wall.
#include "engine/boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/rng.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

template <class Real>
State<Real> scattered(std::uint64_t seed) {
  Rng random(seed);
  State<Real> state = make_state<Real>(3, 294);
  for (std::size_t k = 0; k < state.x.size(); ++k) {
    state.x[k] = static_cast<Real>(random.uniform(-2.2, 2.2));
    state.y[k] = static_cast<Real>(random.uniform(-2.2, 2.2));
    state.z[k] = static_cast<Real>(random.uniform(-0.2, 1));
    state.vx[k] = static_cast<Real>(random.uniform(-3, 3));
    state.vy[k] = static_cast<Real>(random.uniform(-3, 3));
    state.vz[k] = static_cast<Real>(random.uniform(-3, 3));
  }
  for (int pup = 0; pup < 3; ++pup) update_bounds(state, pup);
  return state;
}

TEST(Boundary, EveryPointObeysTheRule) {
  const Params p;
  State<double> now = scattered<double>(1);
  const State<double> old = now;
  for (int pup = 0; pup < now.pups; ++pup) apply_boundaries(p, now, pup);
  int floor_hits = 0, wall_hits = 0;
  for (std::size_t k = 0; k < now.x.size(); ++k) {
    if (static_cast<int>(k % now.stride) >= now.points) continue;  // padding
    Eigen::Vector3d x(old.x[k], old.y[k], old.z[k]), v(old.vx[k], old.vy[k], old.vz[k]);
    if (x.z() - p.point_radius < 0) {
      v.z() = std::abs(v.z());
      x.z() = p.point_radius;
      ++floor_hits;
    }
    const double ax = std::abs(x.x()) + p.point_radius, ay = std::abs(x.y()) + p.point_radius;
    if (ax * ax + ay * ay > p.arena_radius * p.arena_radius) {
      const double phi = std::atan2(x.y(), x.x());
      v = (v + Eigen::Vector3d(-std::cos(phi), -std::sin(phi), 0)) / 2;
      x += p.dt * v;
      ++wall_hits;
    }
    ASSERT_LT((x - Eigen::Vector3d(now.x[k], now.y[k], now.z[k])).norm(), 1e-15);
    ASSERT_LT((v - Eigen::Vector3d(now.vx[k], now.vy[k], now.vz[k])).norm(), 1e-15);
  }
  EXPECT_GT(floor_hits, 50);
  EXPECT_GT(wall_hits, 50);
}

TEST(Boundary, BoundsStayTrue) {
  State<float> state = scattered<float>(2);
  for (int pup = 0; pup < state.pups; ++pup) apply_boundaries(Params{}, state, pup);
  for (int pup = 0; pup < state.pups; ++pup) {
    const Bounds<float> box = state.bounds[pup];
    for (std::size_t k = state.row(pup); k < state.row(pup) + state.points; ++k) {
      ASSERT_GE(state.x[k], box.low[0]);
      ASSERT_LE(state.x[k], box.high[0]);
      ASSERT_GE(state.y[k], box.low[1]);
      ASSERT_LE(state.y[k], box.high[1]);
      ASSERT_GE(state.z[k], box.low[2]);
      ASSERT_LE(state.z[k], box.high[2]);
    }
  }
}

TEST(Boundary, ADrivenLitterStaysInTheArena) {
  // After a step points may dip below the floor by one step's fall, and lean over the wall as far
  // as a pup's deformation lets them while its push turns the others.
  Params p;
  p.ambient_temperature = 0.9;
  p.drive = 2;
  Simulation s(p);
  double lowest = 0, furthest = 0;
  for (int m = 0; m < 1500; ++m) {
    ASSERT_TRUE(s.step().ok());
    for (const auto& x : testing::all_positions(s)) {
      lowest = std::min(lowest, x.z() - p.point_radius);
      const double reach =
          std::hypot(std::abs(x.x()) + p.point_radius, std::abs(x.y()) + p.point_radius);
      furthest = std::max(furthest, reach - p.arena_radius);
    }
  }
  EXPECT_GT(lowest, -0.16);  // the last pup of the column arrives at 15 units a second
  EXPECT_GT(furthest, 0);
  EXPECT_LT(furthest, 0.25);
}

}  // namespace
}  // namespace pupflow
