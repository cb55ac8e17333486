// Where a pup is and how it is turned: known by hand, and fitted anew to the points of a run.
#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "pupflow/fields.h"
#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

Eigen::Vector3d centre_of(const LitterView& litter, int pup) {
  const auto at = [&](const char* name) { return find_field(name)->values(litter)[pup]; };
  return {at("x"), at("y"), at("z")};
}

Eigen::Quaterniond orientation_of(const LitterView& litter, int pup) {
  const auto at = [&](const char* name) { return find_field(name)->values(litter)[pup]; };
  return {at("qw"), at("qx"), at("qy"), at("qz")};
}

/// The proper rotation nearest to the moments of a pup's points, from singular values.
Eigen::Matrix3d fitted_rotation(const LitterView& litter, int pup) {
  const auto rest = cube_sphere(litter.params.face_points, litter.params.pup_radius);
  const Eigen::Vector3d centre = litter.positions.mean(pup);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (int i = 0; i < litter.points; ++i) {
    moments += (litter.positions(pup, i) - centre) * rest[i].transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

void expect_poses(const Simulation& s, double tolerance) {
  for (int pup = 0; pup < s.pups(); ++pup) {
    const LitterView litter = s;
    EXPECT_LT((centre_of(litter, pup) - litter.positions.mean(pup)).norm(), tolerance) << pup;
    const Eigen::Quaterniond q = orientation_of(litter, pup);
    EXPECT_NEAR(q.norm(), 1, 1e-12);
    EXPECT_GE(q.w(), 0);
    EXPECT_LT((q.toRotationMatrix() - fitted_rotation(litter, pup)).norm(), 10 * tolerance) << pup;
  }
}

TEST(Poses, OfALitterThatSomebodyTurnedAndMoved) {
  Params p = testing::weightless();
  p.pups = 2;
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    p.precision = precision;
    Simulation s(p);
    // More than half a turn: the quaternion with w >= 0 turns the other way round.
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(4, Eigen::Vector3d(1, 2, 2) / 3));
    const Eigen::Vector3d moved(0.5, -0.25, 1.5);
    testing::Points points;
    for (const auto& q : cube_sphere(p.face_points, p.pup_radius)) {
      points.push_back(turned * q + moved);
    }
    testing::place(s, 1, points, testing::Points(points.size(), Eigen::Vector3d::Zero()));
    s.set_observed({Part::pose});
    const double tolerance = precision == Precision::float_ ? 1e-6 : 1e-14;
    EXPECT_LT((centre_of(s, 1) - moved).norm(), tolerance);
    EXPECT_LT((orientation_of(s, 1).coeffs() + turned.coeffs()).norm(), 10 * tolerance);
    expect_poses(s, tolerance);
  }
}

/// Edits that change what moves the points last, or leave the fit of the step out.
class PosesOfARun : public ::testing::TestWithParam<void (*)(Params&)> {};

TEST_P(PosesOfARun, FitThePointsAfterEachStep) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p;
    p.pups = 9;  // more than are fitted together
    p.face_points = 3;
    p.arena_radius = 0.7;
    p.precision = precision;
    GetParam()(p);
    Simulation s(p);
    s.set_observed({Part::pose});
    for (int round = 0; round < 20; ++round) {
      expect_poses(s, precision == Precision::float_ ? 2e-5 : 1e-12);
      ASSERT_TRUE(s.run(7).ok());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Edits, PosesOfARun,
                         ::testing::Values(
                             +[](Params&) {}, +[](Params& p) { p.deformation = 1; },
                             +[](Params& p) { p.deformation = 0; },
                             +[](Params& p) { p.rigidity = 0; },
                             +[](Params& p) {
                               p.refinement = Refinement::consistent;
                               p.dt = 0.004;
                             },
                             +[](Params& p) {
                               p.integrator = Integrator::explicit_;
                               p.rigidity = 0.1;
                             }));

TEST(Poses, OfACheckpointAreKnownAtOnce) {
  Params p;
  p.pups = 2;
  p.face_points = 2;
  Simulation first(p);
  first.run(30);
  Simulation second(first.snapshot());
  second.set_observed({Part::pose});
  expect_poses(second, 1e-12);
}

}  // namespace
}  // namespace pupflow
