#include "app/report/error/rotations.h"

#include <Eigen/Dense>
#include <cmath>

#include "engine/rotation.h"
#include "engine/shape_match.h"
#include "pupflow/geometry.h"

namespace pupflow::report {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d by_singular_values(const Matrix3d& a) {
  const Eigen::JacobiSVD<Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

Matrix3d by_closed_form(const Matrix3d& a) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> squares;
  squares.computeDirect(a.transpose() * a);
  const Matrix3d& v = squares.eigenvectors();
  return a * v * squares.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal() * v.transpose();
}

Matrix3d by_horn(const Matrix3d& a) {
  // Horn's matrix for the quaternion that turns the columns of the identity onto those of a.
  const Vector3d twist(a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1));
  Eigen::Matrix4d horn;
  horn(0, 0) = a.trace();
  horn.block<3, 1>(1, 0) = twist;
  horn.block<1, 3>(0, 1) = twist.transpose();
  horn.block<3, 3>(1, 1) = a + a.transpose() - a.trace() * Matrix3d::Identity();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(horn);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

/// Mueller, Bender, Chentanez & Macklin 2016, A robust method to extract the rotational part of
/// deformations.
void mueller(const Matrix3d& a, int iterations, Eigen::Quaterniond& q) {
  for (int i = 0; i < iterations; ++i) {
    const Matrix3d r = q.toRotationMatrix();
    Vector3d omega = Vector3d::Zero();
    double size = 0;
    for (int k = 0; k < 3; ++k) {
      omega += r.col(k).cross(a.col(k));
      size += r.col(k).dot(a.col(k));
    }
    omega /= std::abs(size) + 1e-9;
    const double angle = omega.norm();
    if (angle < 1e-15) return;
    q = Eigen::Quaterniond(Eigen::AngleAxisd(angle, omega / angle)) * q;
    q.normalize();
  }
}

int iterations_of(Routine routine) {
  return routine == Routine::mueller_1 ? 1 : routine == Routine::mueller_3 ? 3 : 5;
}

template <class Real>
void load(const Points& points, AlignedVector<Real>& x, AlignedVector<Real>& y,
          AlignedVector<Real>& z) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector3d& p = points[std::min(i, points.size() - 1)];
    x[i] = static_cast<Real>(p.x());
    y[i] = static_cast<Real>(p.y());
    z[i] = static_cast<Real>(p.z());
  }
}

template <class Real>
Points unload(std::size_t count, const AlignedVector<Real>& x, const AlignedVector<Real>& y,
              const AlignedVector<Real>& z) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(x[i], y[i], z[i]);
  return points;
}

template <class Real>
Outcome run_body(const Params& params, Routine routine, const Points& points,
                 const Points& velocities, int samples, std::size_t quantities,
                 const LookAtPoints& look) {
  const auto cloud = make_cloud<Real>(cube_sphere(params.face_points, params.pup_radius));
  State<Real> state = make_state<Real>(1, points_per_pup(params));
  load(points, state.x, state.y, state.z);
  load(velocities, state.vx, state.vy, state.vz);
  const StepBody body = step_body(params);
  const bool quadratic = params.deformation > 0;
  const auto steps = static_cast<int>(std::lround(kSample / params.dt));
  RotationFinder find(routine);
  Outcome outcome;
  outcome.samples.resize(quantities);
  double spent = 0;
  for (int i = 0; i < samples; ++i) {
    stop_if_interrupted();
    const double begin = thread_seconds();
    for (int k = 0; k < steps; ++k) {
      predict(params, state, 0);
      const BodyFit fit = fit_body(params, body, quadratic, cloud, state, 0);
      const Matrix3d rotation = find(linear_part(fit.shape));
      pull_to_goals(params, body, quadratic, cloud, fit,
                    goal_modes(fit.shape, rotation, cloud.linear_scale, body.beta), state, 0);
    }
    spent += thread_seconds() - begin;
    look(unload(points.size(), state.x, state.y, state.z),
         unload(points.size(), state.vx, state.vy, state.vz), outcome.samples);
  }
  outcome.seconds = spent / (samples * kSample);
  return outcome;
}

}  // namespace

Matrix3d RotationFinder::operator()(const Matrix3d& a) {
  switch (routine_) {
    case Routine::engine:
      return nearest_rotation(a).matrix;
    case Routine::svd:
      return by_singular_values(a);
    case Routine::closed_form:
      return by_closed_form(a);
    case Routine::horn:
      return by_horn(a);
    case Routine::mueller_1:
    case Routine::mueller_3:
    case Routine::mueller_5:
      break;
  }
  if (!started_) last_ = Eigen::Quaterniond(by_singular_values(a));
  started_ = true;
  mueller(a, iterations_of(routine_), last_);
  return last_.toRotationMatrix();
}

Outcome run_with_rotation(const Params& params, Routine routine, const Points& points,
                          const Points& velocities, int samples, std::size_t quantities,
                          const LookAtPoints& look) {
  if (params.precision == Precision::float_) {
    return run_body<float>(params, routine, points, velocities, samples, quantities, look);
  }
  return run_body<double>(params, routine, points, velocities, samples, quantities, look);
}

Aside rotation_aside(const Params& params, std::vector<std::size_t> quantities) {
  const auto with = [&](Routine routine, const std::string& label) {
    return Setting{label, params, static_cast<int>(routine) + 1};
  };
  return {"rotations",
          "Rotation routines",
          "dt = 0.01, with another routine for the rotation, compared with singular values at the "
          "same step. So the error is that of the routine alone. Times do not include boundaries "
          "and checks.",
          with(Routine::svd, "singular values"),
          {with(Routine::engine, "Newton (default)"), with(Routine::closed_form, "closed form"),
           with(Routine::horn, "Horn's quaternion"),
           with(Routine::mueller_1, "Müller 2016, 1 iteration"),
           with(Routine::mueller_3, "Müller 2016, 3 iterations"),
           with(Routine::mueller_5, "Müller 2016, 5 iterations")},
          std::move(quantities)};
}

}  // namespace pupflow::report
