#include "engine/shape_match.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>

#include "engine/cloud.h"
#include "engine/rng.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

using Eigen::MatrixXd;

/// A deformed, moved cloud of the paper's size, as rows of a matrix.
MatrixXd deformed(const std::vector<Eigen::Vector3d>& rest, Rng& random) {
  const Eigen::Matrix3d turn = random.rotation();
  MatrixXd x(rest.size(), 3);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Eigen::Vector3d noise(random.uniform(-1, 1), random.uniform(-1, 1),
                                random.uniform(-1, 1));
    const Eigen::Vector3d bend(0, 0, 0.8 * rest[i].x() * rest[i].x());
    x.row(static_cast<Eigen::Index>(i)) =
        (turn * (rest[i] + bend) + Eigen::Vector3d(0.5, -1, 2) + 0.02 * noise).transpose();
  }
  return x;
}

State<double> state_of(const MatrixXd& x) {
  State<double> state = make_state<double>(1, static_cast<int>(x.rows()));
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    state.x[i] = x(i, 0);
    state.y[i] = x(i, 1);
    state.z[i] = x(i, 2);
  }
  return state;
}

/// Goals by the textbook: nine monomials, pseudo-inverse by eigenvalues, rotation by SVD.
MatrixXd textbook_goals(const std::vector<Eigen::Vector3d>& rest, const MatrixXd& x, double beta) {
  const auto n = static_cast<Eigen::Index>(rest.size());
  MatrixXd q(n, 9);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& p = rest[static_cast<std::size_t>(i)];
    q.row(i) << p.x(), p.y(), p.z(), p.x() * p.x(), p.y() * p.y(), p.z() * p.z(), p.x() * p.y(),
        p.y() * p.z(), p.z() * p.x();
  }
  q.rowwise() -= q.colwise().mean();
  const Eigen::RowVector3d centre = x.colwise().mean();
  const MatrixXd a = (x.rowwise() - centre).transpose() * q;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> moments(q.transpose() * q);
  Eigen::VectorXd inverse = moments.eigenvalues();
  for (auto& value : inverse) value = value > 1e-10 * moments.eigenvalues()[8] ? 1 / value : 0;
  const MatrixXd b =
      a * moments.eigenvectors() * inverse.asDiagonal() * moments.eigenvectors().transpose();
  const Eigen::Matrix3d linear = a.leftCols<3>();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = linear.determinant() < 0 ? -1 : 1;
  const Eigen::Matrix3d r =
      svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  MatrixXd t = beta * b;
  t.leftCols<3>() += (1 - beta) * r;
  const double det = Eigen::Matrix3d(t.leftCols<3>()).determinant();
  t.leftCols<3>() *= std::min(std::pow(std::abs(det), -1.0 / 3), 3.0);
  return (q * t.transpose()).rowwise() + centre;
}

TEST(ShapeMatch, GoalsAreThoseOfTheTextbook) {
  const auto rest = cube_sphere(7, 0.25);
  const auto cloud = make_cloud<double>(rest);
  Rng random(1);
  for (const double beta : {0.0, 0.3, 0.5, 0.9}) {
    const MatrixXd x = deformed(rest, random);
    const State<double> state = state_of(x);
    const ModeMatrix fit = fit_modes(cloud, state, 0, beta > 0);
    const Rotation rotation = nearest_rotation(linear_part(fit));
    const ModeMatrix goal = goal_modes(fit, rotation.matrix, cloud.linear_scale, beta);
    EXPECT_EQ(rotation.kind, RotationKind::regular);
    const MatrixXd expected = textbook_goals(rest, x, beta);
    for (int i = 0; i < cloud.points; ++i) {
      Eigen::Vector3d g = x.row(0).transpose() + goal.col(kMeanMode);
      for (int m = 1; m < kModes; ++m) g += goal.col(m) * cloud.mode_row(m)[i];
      ASSERT_LT((g.transpose() - expected.row(i)).norm(), 1e-12)
          << "beta " << beta << " point " << i;
    }
  }
}

template <class Real>
class Goals : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Goals, Precisions);

TYPED_TEST(Goals, KeepTheCentreOfMass) {
  const auto rest = cube_sphere(7, 0.25);
  const auto cloud = make_cloud<TypeParam>(rest);
  Rng random(2);
  const MatrixXd x = deformed(rest, random);
  State<TypeParam> state = make_state<TypeParam>(1, cloud.points);
  for (int i = 0; i < cloud.points; ++i) {
    state.x[i] = static_cast<TypeParam>(x(i, 0));
    state.y[i] = static_cast<TypeParam>(x(i, 1));
    state.z[i] = static_cast<TypeParam>(x(i, 2));
  }
  const auto centre = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < cloud.points; ++i) {
      sum += Eigen::Vector3d(state.x[i], state.y[i], state.z[i]) / cloud.points;
    }
    return sum;
  };
  Params params;
  params.rigidity = 1;  // points end on their goals
  const Eigen::Vector3d before = centre();
  match_shapes(params, step_body(params), {}, cloud, state, 0, 1);
  EXPECT_LT((centre() - before).norm(), sizeof(TypeParam) == 4 ? 2e-7 : 5e-15);
}

TEST(ShapeMatch, CloudsWithoutShapeStayFinite) {
  const auto rest = cube_sphere(7, 0.25);
  const auto cloud = make_cloud<double>(rest);
  const auto point = [](const Eigen::Vector3d&) { return Eigen::Vector3d(1, 2, 3); };
  const auto line = [](const Eigen::Vector3d& q) { return Eigen::Vector3d(q.x(), 0, 1); };
  const auto flat = [](const Eigen::Vector3d& q) { return Eigen::Vector3d(q.x(), q.y(), 1); };
  const auto mirror = [](const Eigen::Vector3d& q) {
    return Eigen::Vector3d(-q.x(), q.y(), q.z());
  };
  const auto check = [&](auto shape, RotationKind expected) {
    State<double> state = make_state<double>(1, cloud.points);
    for (int i = 0; i < cloud.points; ++i) {
      const Eigen::Vector3d p = shape(rest[i]);
      state.x[i] = p.x();
      state.y[i] = p.y();
      state.z[i] = p.z();
    }
    EXPECT_EQ(match_shapes(Params{}, step_body(Params{}), {}, cloud, state, 0, 1),
              expected == RotationKind::regular ? 0 : 1);
    for (int i = 0; i < state.stride; ++i) {
      ASSERT_TRUE(std::isfinite(state.x[i]) && std::isfinite(state.y[i]) &&
                  std::isfinite(state.z[i]));
    }
  };
  check(point, RotationKind::arbitrary);
  check(line, RotationKind::arbitrary);
  check(flat, RotationKind::fallback);
  check(mirror, RotationKind::fallback);
}

}  // namespace
}  // namespace pupflow
