#include "engine/contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/rng.h"

namespace pupflow {
namespace {

/// The whole stage, on one thread.
template <class Real>
Status resolve(Contacts<Real>& contacts, const Params& params, State<Real>& state) {
  Team team;
  contacts.find(params, {}, state, team);
  Status first;
  for (int pup = 0; pup < state.pups; ++pup) {
    const Status status = contacts.apply(params, 1, state, pup, 0);
    if (first.ok()) first = status;
  }
  return first;
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

TEST(ContactStage, AtEqualHeightsTheLowerIndexMoves) {
  Params params;
  Contacts<double> contacts;
  State<double> state = two_points(1, 1, 0.06);
  resolve(contacts, params, state);
  EXPECT_NEAR(state.x[0], -0.06 * 0.04, 1e-15);
  EXPECT_EQ(state.x[state.row(1)], 0.06);
  EXPECT_NEAR(state.vx[0], 0.06, 1e-15);  // towards the other: the rule attracts
}

/// Pups whose points stand at given places.
State<double> points_at(const std::vector<std::vector<Eigen::Vector3d>>& pups) {
  State<double> state =
      make_state<double>(static_cast<int>(pups.size()), static_cast<int>(pups[0].size()));
  for (int pup = 0; pup < state.pups; ++pup) {
    for (int i = 0; i < state.stride; ++i) {
      const auto& points = pups[static_cast<std::size_t>(pup)];
      const Eigen::Vector3d& p = points[std::min<std::size_t>(i, points.size() - 1)];
      const std::size_t k = state.row(pup) + i;
      state.x[k] = p.x();
      state.y[k] = p.y();
      state.z[k] = p.z();
    }
    update_bounds(state, pup);
  }
  return state;
}

/// A point at (0, 0, 1) over two lower ones of another pup, 0.05 and 0.03 below; r = 0.05.
State<double> over_two(ContactRule rule) {
  Params params;
  params.contact = rule;
  Contacts<double> contacts;
  State<double> state = points_at({{{0, 0, 1}, {0, 0, 5}}, {{0, 0, 0.95}, {0, 0, 0.97}}});
  resolve(contacts, params, state);
  return state;
}

TEST(ContactStage, TheNearestLowerPointAloneMovesAPoint) {
  const State<double> state = over_two(ContactRule::nearest);
  EXPECT_NEAR(state.z[0], 1 + 0.03 * 0.07, 1e-15);
  EXPECT_NEAR(state.vz[0], -0.03, 1e-15);
}

TEST(ContactStage, MeanAndSumTakeAllLowerPoints) {
  const double sum = 0.05 * 0.05 + 0.03 * 0.07;
  State<double> state = over_two(ContactRule::mean);
  EXPECT_NEAR(state.z[0], 1 + sum / 2, 1e-15);
  EXPECT_NEAR(state.vz[0], -0.04, 1e-15);
  state = over_two(ContactRule::sum);
  EXPECT_NEAR(state.z[0], 1 + sum, 1e-15);
  EXPECT_NEAR(state.vz[0], -0.04, 1e-15);
}

TEST(ContactStage, AnUpperPointMayBeNearerAndDoesNotMoveIt) {
  Params params;
  Contacts<double> contacts;
  // Pup 1's points: one above at 0.01, one below at 0.06. The first says what is felt, not where to
  // go; it moves itself.
  State<double> state = points_at({{{0, 0, 1}, {0, 0, 5}}, {{0, 0, 1.01}, {0, 0, 0.94}}});
  resolve(contacts, params, state);
  EXPECT_NEAR(state.z[0], 1 + 0.06 * 0.04, 1e-15);
  EXPECT_NEAR(state.z[state.row(1)], 1.01 + 0.01 * 0.09, 1e-15);
  EXPECT_EQ(state.z[state.row(1) + 1], 0.94);
}

TEST(ContactStage, OfEquallyNearPointsTheLowerPupThenTheLowerPointMoves) {
  Params params;
  Contacts<double> contacts;
  // Distances are exact in binary. Pup 2's point 0 lies over two points of pup 0 and one of pup 1.
  const double d = 0.0625, z = 1 - d;
  State<double> state =
      points_at({{{d, 0, z}, {-d, 0, z}}, {{0, d, z}, {0, 9, 9}}, {{0, 0, 1}, {9, 9, 9}}});
  resolve(contacts, params, state);
  EXPECT_EQ(state.vx[state.row(2)], d);
  EXPECT_EQ(state.vy[state.row(2)], 0);
  EXPECT_EQ(state.touched[state.flat(2)], 0);
  // With pups 0 and 1 changed about, pup 0 is the one at (0, d).
  state = points_at({{{0, d, z}, {0, 9, 9}}, {{d, 0, z}, {-d, 0, z}}, {{0, 0, 1}, {9, 9, 9}}});
  resolve(contacts, params, state);
  EXPECT_EQ(state.vx[state.row(2)], 0);
  EXPECT_EQ(state.vy[state.row(2)], d);
}

/// The tie rule holds wherever in a pack the points stand, on both sides of a pair.
TEST(ContactStage, EquallyNearPointsInAnyLane) {
  Params params;
  const double d = 0.0625, z = 1 - d;
  for (const InstructionSet set : supported_instruction_sets()) {
    for (int first = 0; first < 40; ++first) {
      const int second = 40 - first / 2;
      std::vector<Eigen::Vector3d> many(48, {9, 9, 9}), single(48, {-9, 9, 9});
      many[static_cast<std::size_t>(first)] = {d, 0, z};
      many[static_cast<std::size_t>(second)] = {-d, 0, z};
      single[7] = {0, 0, 1};
      for (const bool swapped : {false, true}) {
        State<double> state = swapped ? points_at({single, many}) : points_at({many, single});
        state.kernels = &kernels_for<double>(set);
        Contacts<double> contacts;
        resolve(contacts, params, state);
        EXPECT_EQ(state.vx[state.row(swapped ? 0 : 1) + 7], first < second ? d : -d)
            << first << ' ' << swapped;
      }
    }
  }
}

TEST(ContactStage, CoincidentPointsTouchAndStayFinite) {
  Params params;
  Contacts<double> contacts;
  State<double> state = two_points(1, 1, 0);
  EXPECT_TRUE(resolve(contacts, params, state).ok());
  EXPECT_EQ(state.touching.size(), 1u);
  EXPECT_EQ(state.x[0], 0);
  EXPECT_EQ(state.exposed[0], 0);
}

TEST(ContactStage, TouchingIsStrict) {
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
    std::vector<NearPair> expected;
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
    EXPECT_EQ(broad_phase.near_pairs(boxes, 0.1), expected);
  }
}

}  // namespace
}  // namespace pupflow
