#include "engine/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/cloud.h"
#include "engine/rng.h"

namespace pupflow {
namespace {

/// The whole stage, on one thread.
template <class Real>
Status resolve(Contacts<Real>& contacts, const Params& params, State<Real>& state) {
  Team team;
  contacts.find(params, state, team);
  Status first;
  for (int pup = 0; pup < state.pups; ++pup) {
    const Status status = contacts.apply(params, 1, true, state, pup, 0);
    if (first.ok()) first = status;
  }
  return first;
}

template <class Real>
State<Real> random_pile(int pups, double spread, std::uint64_t seed) {
  Rng random(seed);
  const auto rest = cube_sphere(5, 0.25);
  State<Real> state = make_state<Real>(pups, static_cast<int>(rest.size()));
  for (int pup = 0; pup < pups; ++pup) {
    const Eigen::Vector3d centre(random.uniform(-spread, spread), random.uniform(-spread, spread),
                                 random.uniform(0.3, 0.3 + spread));
    const Eigen::Matrix3d turn = random.rotation();
    for (int i = 0; i < state.stride; ++i) {
      const Eigen::Vector3d p =
          i < state.points ? Eigen::Vector3d(centre + turn * rest[i]) : Eigen::Vector3d(centre);
      const std::size_t k = state.row(pup) + i;
      state.x[k] = static_cast<Real>(p.x());
      state.y[k] = static_cast<Real>(p.y());
      state.z[k] = static_cast<Real>(p.z());
      state.vx[k] = static_cast<Real>(random.uniform(-1, 1));
    }
    update_bounds(state, pup);
  }
  return state;
}

/// The contact rule, straight from its definition: every point against every other.
template <class Real>
State<Real> brute_force(const State<Real>& before, double point_radius) {
  State<Real> after = before;
  std::set<std::pair<int, int>> touching;
  const double reach = 2 * point_radius;
  const auto at = [&](std::size_t k) {
    return Eigen::Vector3d(before.x[k], before.y[k], before.z[k]);
  };
  for (int j = 0; j < before.pups; ++j) {
    int contacts = 0;
    for (int i = 0; i < before.points; ++i) {
      const std::size_t a = before.row(j) + i;
      Eigen::Vector3d push = Eigen::Vector3d::Zero(), pull = Eigen::Vector3d::Zero();
      int uppers = 0, owner = -1;
      double nearest = reach;
      for (int k = 0; k < before.pups; ++k) {
        if (k == j) continue;
        for (int l = 0; l < before.points; ++l) {
          const std::size_t b = before.row(k) + l;
          const Eigen::Vector3d e = at(a) - at(b);
          const double d = e.norm();
          if (!(d < reach)) continue;
          touching.insert({std::min(j, k), std::max(j, k)});
          if (d < nearest) {
            nearest = d;
            owner = k;
          }
          const bool upper = before.z[a] != before.z[b] ? before.z[a] > before.z[b] : j < k;
          if (!upper) continue;
          push += e * (reach - d);
          pull -= e;
          ++uppers;
        }
      }
      after.touched[before.flat(j) + i] = owner;
      contacts += owner >= 0 ? 1 : 0;
      if (uppers == 0) continue;
      after.x[a] += static_cast<Real>(push.x());
      after.y[a] += static_cast<Real>(push.y());
      after.z[a] += static_cast<Real>(push.z());
      after.vx[a] = static_cast<Real>(pull.x() / uppers);
      after.vy[a] = static_cast<Real>(pull.y() / uppers);
      after.vz[a] = static_cast<Real>(pull.z() / uppers);
    }
    after.exposed[j] = 1 - static_cast<double>(contacts) / before.points;
  }
  after.touching.clear();
  for (const auto& [a, b] : touching) after.touching.push_back({a, b});
  return after;
}

template <class Real>
class ContactRule : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ContactRule, Precisions);

TYPED_TEST(ContactRule, BroadPhaseFindsWhatBruteForceFinds) {
  const double tolerance = sizeof(TypeParam) == 4 ? 2e-6 : 1e-14;
  Params params;
  Contacts<TypeParam> contacts;  // reused, as a step does
  std::size_t seen = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    State<TypeParam> state = random_pile<TypeParam>(3 + static_cast<int>(seed) % 8,
                                                    0.2 + 0.05 * static_cast<double>(seed), seed);
    const State<TypeParam> expected = brute_force(state, params.point_radius);
    ASSERT_TRUE(resolve(contacts, params, state).ok());
    EXPECT_EQ(state.touching, expected.touching);
    EXPECT_EQ(state.touched, expected.touched);
    seen += state.touching.size();
    for (int j = 0; j < state.pups; ++j) EXPECT_NEAR(state.exposed[j], expected.exposed[j], 1e-12);
    for (int j = 0; j < state.pups; ++j) {
      for (int i = 0; i < state.points; ++i) {
        const std::size_t k = state.row(j) + i;
        ASSERT_NEAR(state.x[k], expected.x[k], tolerance);
        ASSERT_NEAR(state.y[k], expected.y[k], tolerance);
        ASSERT_NEAR(state.z[k], expected.z[k], tolerance);
        ASSERT_NEAR(state.vx[k], expected.vx[k], tolerance);
        ASSERT_NEAR(state.vy[k], expected.vy[k], tolerance);
        ASSERT_NEAR(state.vz[k], expected.vz[k], tolerance);
      }
    }
  }
  EXPECT_GT(seen, 30u);
}

/// Two pups of one point each (a cloud needs no shape here), at given heights and distance.
State<double> two_points(double z0, double z1, double distance) {
  State<double> state = make_state<double>(2, 1);
  for (int i = 0; i < state.stride; ++i) {
    state.z[i] = z0;
    state.z[state.row(1) + i] = z1;
    state.x[state.row(1) + i] = distance;
  }
  update_bounds(state, 0);
  update_bounds(state, 1);
  return state;
}

TEST(ContactRule, AtEqualHeightsTheLowerIndexMoves) {
  Params params;
  Contacts<double> contacts;
  State<double> state = two_points(1, 1, 0.06);
  resolve(contacts, params, state);
  EXPECT_NEAR(state.x[0], -0.06 * 0.04, 1e-15);
  EXPECT_EQ(state.x[state.row(1)], 0.06);
  EXPECT_NEAR(state.vx[0], 0.06, 1e-15);  // towards the other: the rule attracts
}

TEST(ContactRule, CoincidentPointsTouchAndStayFinite) {
  Params params;
  Contacts<double> contacts;
  State<double> state = two_points(1, 1, 0);
  EXPECT_TRUE(resolve(contacts, params, state).ok());
  EXPECT_EQ(state.touching.size(), 1u);
  EXPECT_EQ(state.x[0], 0);
  EXPECT_EQ(state.exposed[0], 0);
}

TEST(ContactRule, TouchingIsStrict) {
  Params params;
  params.point_radius = 0.25;
  Contacts<double> contacts;
  State<double> apart = two_points(1, 1, 0.5);
  resolve(contacts, params, apart);
  EXPECT_TRUE(apart.touching.empty());
  State<double> near = two_points(1, 1, std::nextafter(0.5, 0));
  resolve(contacts, params, near);
  EXPECT_EQ(near.touching.size(), 1u);
}

TEST(BroadPhase, FindsAllOverlapsSorted) {
  Rng random(3);
  BroadPhase<double> broad_phase;
  for (int round = 0; round < 20; ++round) {
    std::vector<Bounds<double>> boxes(40);
    for (auto& box : boxes) {
      for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = random.uniform(0, 3);
        box.high[axis] = box.low[axis] + random.uniform(0, 1);
      }
    }
    std::vector<TouchingPair> expected;
    for (int a = 0; a < 40; ++a) {
      for (int b = a + 1; b < 40; ++b) {
        bool near = true;
        for (int axis = 0; axis < 3; ++axis) {
          near = near && boxes[a].low[axis] <= boxes[b].high[axis] + 0.1 &&
                 boxes[b].low[axis] <= boxes[a].high[axis] + 0.1;
        }
        if (near) expected.push_back({a, b});
      }
    }
    EXPECT_EQ(broad_phase.find(boxes, 0.1), expected);
  }
}

}  // namespace
}  // namespace pupflow
