// Contacts against their definition: every point compared with every other, in the precision of
// the litter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "engine/contact.h"
#include "engine/rng.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

/// What a litter looks like.
enum class Scene { pile, heap, flat, mirrored, copies, points, far };
constexpr Scene kScenes[] = {Scene::pile,   Scene::heap,   Scene::flat, Scene::mirrored,
                             Scene::copies, Scene::points, Scene::far};
constexpr const char* kNames[] = {"pile", "heap", "flat", "mirrored", "copies", "points", "far"};

template <class Real>
State<Real> make_scene(Scene scene, int pups, int face_points, std::uint64_t seed) {
  Rng random(seed);
  const auto rest = cube_sphere(face_points, 0.25);
  State<Real> state = make_state<Real>(pups, static_cast<int>(rest.size()));
  const double spread = scene == Scene::heap || scene == Scene::points ? 0.05 : 0.35;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();
  for (int pup = 0; pup < pups; ++pup) {
    if (scene != Scene::copies || pup % 2 == 0) {  // a copy stands where its original does
      for (int axis = 0; axis < 3; ++axis) centre[axis] = random.uniform(-spread, spread);
      shape = random.rotation();
      for (int axis = 0; axis < 3; ++axis) shape.row(axis) *= random.uniform(0.6, 1.2);
    }
    if (scene == Scene::flat) centre.z() = shape.row(2).setZero()(0);
    if (scene == Scene::mirrored && pup % 2 == 1) shape.row(0) *= -1;
    if (scene == Scene::points) shape.setZero();  // all points of a pup in one place
    const Eigen::Vector3d away =
        scene == Scene::far ? Eigen::Vector3d(1000, -2000, 3000) : Eigen::Vector3d::Zero();
    for (int i = 0; i < state.stride; ++i) {
      const Eigen::Vector3d& q = rest[std::min<std::size_t>(i, rest.size() - 1)];
      const Eigen::Vector3d p = away + centre + shape * q;
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

/// All contacts of one point.
template <class Real>
struct PointContacts {
  int owner = -1;           // pup of the nearest touching point
  std::size_t lower = 0;    // the nearest touching lower point, if any
  Real lower_squared = -1;  // its squared distance; -1 without one
  int movers = 0;           // touching lower points, and sums over them, in double:
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero(), apart = Eigen::Vector3d::Zero();
};

template <class Real>
struct BruteForce {
  std::vector<PointContacts<Real>> points;  // pup by pup
  std::vector<TouchingPair> touching;

  BruteForce(const State<Real>& state, Real reach) : points(state.flat(state.pups)) {
    std::set<std::pair<int, int>> pairs;
    for (int j = 0; j < state.pups; ++j) {
      for (int i = 0; i < state.points; ++i) {
        Real nearest = reach * reach;
        PointContacts<Real>& point = points[state.flat(j) + i];
        for (int k = 0; k < state.pups; ++k) {
          for (int l = 0; l < state.points && k != j; ++l) {
            if (meet(state, reach, j, state.row(j) + i, k, state.row(k) + l, nearest, point)) {
              pairs.insert({std::min(j, k), std::max(j, k)});
            }
          }
        }
      }
    }
    for (const auto& [a, b] : pairs) touching.push_back({a, b});
  }

 private:
  /// Point a of pup j and point b of pup k. Returns whether they touch.
  static bool meet(const State<Real>& state, Real reach, int j, std::size_t a, int k, std::size_t b,
                   Real& nearest, PointContacts<Real>& point) {
    const Real e[3] = {state.x[a] - state.x[b], state.y[a] - state.y[b], state.z[a] - state.z[b]};
    const Real squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
    if (!(squared < reach * reach)) return false;
    if (squared < nearest) {
      nearest = squared;
      point.owner = k;
    }
    if (e[2] < 0 || (e[2] == 0 && k < j)) return true;  // a is the lower one
    if (point.lower_squared < 0 || squared < point.lower_squared) {
      point.lower_squared = squared;
      point.lower = b;
    }
    const Eigen::Vector3d apart(e[0], e[1], e[2]);
    ++point.movers;
    point.apart += apart;
    point.displacement += apart * (reach - std::sqrt(squared));
    return true;
  }
};

/// A coordinate of a point, number a of the litter, and its velocity, after the contacts.
template <class Real>
struct Moved {
  double at, velocity;
};
template <class Real>
Moved<Real> moved(const State<Real>& before, ContactRule rule, Real reach,
                  const PointContacts<Real>& point, std::size_t a, int axis) {
  const AlignedVector<Real>& x = axis == 0 ? before.x : axis == 1 ? before.y : before.z;
  const AlignedVector<Real>& v = axis == 0 ? before.vx : axis == 1 ? before.vy : before.vz;
  if (point.movers == 0) return {x[a], v[a]};
  if (rule == ContactRule::nearest) {  // to the bit
    const Real apart = x[a] - x[point.lower];
    const Real at = x[a] + apart * (reach - std::sqrt(point.lower_squared));
    return {at, -apart};
  }
  const double share = rule == ContactRule::mean ? 1.0 / point.movers : 1;
  return {x[a] + share * point.displacement[axis], -point.apart[axis] / point.movers};
}

template <class Real>
void expect_moved(const State<Real>& before, const State<Real>& after, ContactRule rule, Real reach,
                  const BruteForce<Real>& expected) {
  const AlignedVector<Real>* const at[3] = {&after.x, &after.y, &after.z};
  const AlignedVector<Real>* const velocity[3] = {&after.vx, &after.vy, &after.vz};
  const double epsilon = std::numeric_limits<Real>::epsilon();
  for (int j = 0; j < before.pups; ++j) {
    for (int i = 0; i < before.points; ++i) {
      const PointContacts<Real>& point = expected.points[before.flat(j) + i];
      const std::size_t a = before.row(j) + i;
      for (int axis = 0; axis < 3; ++axis) {
        const Moved<Real> want = moved(before, rule, reach, point, a, axis);
        // A term is at most reach^2 / 4. Each of n sums may round by epsilon / 2 of n terms.
        const double slack = rule == ContactRule::nearest
                                 ? 0
                                 : epsilon * (1.0 * point.movers * point.movers * reach * reach +
                                              4 * std::abs(want.at));
        ASSERT_NEAR((*at[axis])[a], want.at, slack) << j << ' ' << i << ' ' << axis;
        ASSERT_NEAR((*velocity[axis])[a], want.velocity,
                    rule == ContactRule::nearest ? 0 : epsilon * 4.0 * (point.movers + 1) * reach)
            << j << ' ' << i << ' ' << axis;
      }
    }
  }
}

/// Returns how many pairs touch.
template <class Real>
std::size_t expect_contacts(const State<Real>& before, Contacts<Real>& contacts) {
  Params params;
  const auto reach = static_cast<Real>(2 * params.point_radius);
  const BruteForce<Real> expected(before, reach);
  for (const InstructionSet set : supported_instruction_sets()) {
    for (const ContactRule rule : {ContactRule::nearest, ContactRule::mean, ContactRule::sum}) {
      SCOPED_TRACE(std::string(instruction_set_name(set)) + ", rule " +
                   std::to_string(static_cast<int>(rule)));
      params.contact = rule;
      State<Real> state = before;
      state.kernels = &kernels_for<Real>(set);
      Team team;
      contacts.find(params, {}, state, team);
      for (int j = 0; j < state.pups; ++j) {
        EXPECT_TRUE(contacts.apply(params, 1, state, j, 0).ok());
        int touching = 0;
        for (int i = 0; i < state.points; ++i) {
          const int owner = expected.points[state.flat(j) + i].owner;
          EXPECT_EQ(state.touched[state.flat(j) + i], owner) << j << ' ' << i;
          touching += owner >= 0 ? 1 : 0;
        }
        EXPECT_EQ(state.exposed[j], static_cast<double>(state.points - touching) / state.points);
      }
      EXPECT_EQ(state.touching, expected.touching);
      expect_moved(before, state, rule, reach, expected);
      if (::testing::Test::HasFailure()) return 0;
    }
  }
  return expected.touching.size();
}

template <class Real>
class ContactsByBruteForce : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ContactsByBruteForce, Precisions);

TYPED_TEST(ContactsByBruteForce, InEveryScene) {
  Contacts<TypeParam> contacts;  // reused, as a step does
  for (const Scene scene : kScenes) {
    std::size_t touching = 0;
    for (const int face_points : {2, 3, 5, 7, 10}) {
      SCOPED_TRACE(std::string(kNames[static_cast<int>(scene)]) + ", k " +
                   std::to_string(face_points));
      const int pups = face_points > 6 ? 4 : 7;
      const auto seed = static_cast<std::uint64_t>(100 * face_points + 7);
      touching += expect_contacts(make_scene<TypeParam>(scene, pups, face_points, seed), contacts);
      if (this->HasFailure()) return;
    }
    EXPECT_GT(touching, 10u) << kNames[static_cast<int>(scene)];
  }
}

TYPED_TEST(ContactsByBruteForce, OfTheLargestClouds) {
  Contacts<TypeParam> contacts;
  for (const Scene scene : {Scene::pile, Scene::flat}) {
    EXPECT_EQ(expect_contacts(make_scene<TypeParam>(scene, 2, kMaxFacePoints, 3), contacts), 1u);
  }
}

TYPED_TEST(ContactsByBruteForce, OfLoosePiles) {
  Contacts<TypeParam> contacts;
  std::size_t touching = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    touching +=
        expect_contacts(make_scene<TypeParam>(Scene::pile, 3 + seed % 8, 4, seed), contacts);
    if (this->HasFailure()) return;
  }
  EXPECT_GT(touching, 50u);
}

}  // namespace
}  // namespace pupflow
