#include "bench/plain_eigen.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "bench/scalar_model.h"
#include "pupflow/geometry.h"

namespace pupflow::bench {
namespace {

using Modes9 = Eigen::Matrix<double, 9, 1>;

std::vector<Modes9> centred_modes(const std::vector<Eigen::Vector3d>& rest) {
  std::vector<Modes9> modes;
  Modes9 mean = Modes9::Zero();
  for (const Eigen::Vector3d& p : rest) {
    const double x = p.x(), y = p.y(), z = p.z();
    Modes9 q;
    q << x, y, z, x * x, y * y, z * z, x * y, y * z, z * x;
    modes.push_back(q);
    mean += q / static_cast<double>(rest.size());
  }
  for (Modes9& q : modes) q -= mean;
  return modes;
}

template <class Vector>
void append(const Vector& from, std::vector<double>& to) {
  for (int axis = 0; axis < 3; ++axis) to.push_back(static_cast<double>(from[axis]));
}

}  // namespace

template <class Real>
PlainEigen<Real>::PlainEigen(const Snapshot& start) : params_(start.params) {
  require_baseline_model(params_);
  const auto modes = centred_modes(cube_sphere(params_.face_points, params_.pup_radius));
  Eigen::Matrix<double, 9, 9> sum = Eigen::Matrix<double, 9, 9>::Zero();
  for (const Modes9& q : modes) {
    sum += q * q.transpose();
    rest_.push_back(q.cast<Real>());
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 9, 9>> decomposition;
  decomposition.setThreshold(1e-10);
  rest_inverse_ = decomposition.compute(sum).pseudoInverse().cast<Real>();
  std::size_t next = 0;
  for (std::size_t j = 0; j < start.body_temperature.size(); ++j) {
    Pup pup;
    pup.tb = start.body_temperature[j];
    pup.heading = start.heading[j];
    pup.exposed = start.exposed[j];
    for (std::size_t i = 0; i < modes.size(); ++i, next += 3) {
      Point point;
      point.position = Eigen::Vector3d(start.positions.data() + next).cast<Real>();
      point.velocity = Eigen::Vector3d(start.velocities.data() + next).cast<Real>();
      pup.points.push_back(point);
    }
    measure_box(pup);
    pups_.push_back(std::move(pup));
  }
}

template <class Real>
void PlainEigen<Real>::floor_and_wall(Pup& pup) const {
  const Real r = static_cast<Real>(params_.point_radius);
  const Real arena = static_cast<Real>(params_.arena_radius);
  for (Point& point : pup.points) {
    Vector& p = point.position;
    Vector& v = point.velocity;
    if (p.z() < r) {
      v.z() = std::abs(v.z());
      p.z() = r;
    }
    const Real dx = std::abs(p.x()) + r, dy = std::abs(p.y()) + r;
    if (dx * dx + dy * dy > arena * arena) {
      const Vector inwards = -Vector(p.x(), p.y(), 0).normalized();
      v = (v + inwards) / 2;
      p += static_cast<Real>(params_.dt) * v;
    }
  }
}

template <class Real>
void PlainEigen<Real>::measure_box(Pup& pup) const {
  pup.low = pup.high = pup.points.front().position;
  for (const Point& point : pup.points) {
    pup.low = pup.low.cwiseMin(point.position);
    pup.high = pup.high.cwiseMax(point.position);
  }
}

template <class Real>
std::vector<int> PlainEigen<Real>::points_near(const Pup& pup, const Pup& other) const {
  const Real reach = static_cast<Real>(2 * params_.point_radius);
  const Vector low = other.low.array() - reach, high = other.high.array() + reach;
  std::vector<int> near;
  for (std::size_t i = 0; i < pup.points.size(); ++i) {
    const Vector& p = pup.points[i].position;
    if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all()) {
      near.push_back(static_cast<int>(i));
    }
  }
  return near;
}

template <class Real>
void PlainEigen<Real>::meet(Point& upper, const Point& lower, Real squared) {
  if (upper.moves && !(squared < upper.lower)) return;
  upper.moves = true;
  upper.lower = squared;
  upper.partner = lower.position;
}

template <class Real>
bool PlainEigen<Real>::search_pair(int first, int second) {
  Pup &a = pups_[first], &b = pups_[second];
  const Real reach = static_cast<Real>(2 * params_.point_radius);
  if ((a.low.array() - reach > b.high.array()).any() ||
      (b.low.array() - reach > a.high.array()).any()) {
    return false;
  }
  const std::vector<int> near_a = points_near(a, b), near_b = points_near(b, a);
  bool any = false;
  for (const int i : near_a) {
    Point& p = a.points[i];
    for (const int j : near_b) {
      Point& q = b.points[j];
      const Real squared = (p.position - q.position).squaredNorm();
      if (!(squared < reach * reach)) continue;
      any = true;
      if (p.touched < 0 || squared < p.nearest) {
        p.touched = second;
        p.nearest = squared;
      }
      if (q.touched < 0 || squared < q.nearest) {
        q.touched = first;
        q.nearest = squared;
      }
      if (p.position.z() >= q.position.z()) {
        meet(p, q, squared);
      } else {
        meet(q, p, squared);
      }
    }
  }
  return any;
}

template <class Real>
void PlainEigen<Real>::resolve_contacts(Pup& pup) const {
  int contacts = 0;
  for (Point& point : pup.points) {
    contacts += point.touched >= 0 ? 1 : 0;
    if (!point.moves) continue;
    const Vector e = point.position - point.partner;
    point.position += e * (static_cast<Real>(2 * params_.point_radius) - std::sqrt(point.lower));
    point.velocity = -e;
  }
  pup.exposed = 1 - contacts / static_cast<double>(pup.points.size());
}

template <class Real>
void PlainEigen<Real>::contacts() {
  touching_.clear();
  for (Pup& pup : pups_) {
    measure_box(pup);
    for (Point& point : pup.points) {
      point.moves = false;
      point.touched = -1;
    }
  }
  const int pups = static_cast<int>(pups_.size());
  for (int first = 0; first < pups; ++first) {
    for (int second = first + 1; second < pups; ++second) {
      if (search_pair(first, second)) touching_.push_back({first, second});
    }
  }
  for (Pup& pup : pups_) resolve_contacts(pup);
}

template <class Real>
void PlainEigen<Real>::steer(Pup& pup) const {
  Vector centre = Vector::Zero();
  for (const Point& point : pup.points) centre += point.position;
  centre /= static_cast<Real>(pup.points.size());
  const Real cosine = static_cast<Real>(std::cos(pup.heading)),
             sine = static_cast<Real>(std::sin(pup.heading));
  double left = 0, right = 0;
  int on_left = 0, on_right = 0;
  for (const Point& point : pup.points) {
    const Vector offset = point.position - centre;
    const double felt = point.touched >= 0 ? pups_[point.touched].tb : params_.ambient_temperature;
    if (cosine * offset.y() - sine * offset.x() > 0) {
      left += felt;
      ++on_left;
    } else {
      right += felt;
      ++on_right;
    }
  }
  if (on_left == 0 || on_right == 0) return;
  const double turn = turn_of(params_, pup.tb, left / on_left, right / on_right);
  pup.heading = wrapped(pup.heading + params_.dt * turn);
}

template <class Real>
void PlainEigen<Real>::warm() {
  std::vector<double> next;
  for (const Pup& pup : pups_) {
    double sum = 0;
    int count = 0;
    for (const Point& point : pup.points) {
      if (point.touched < 0) continue;
      sum += pups_[point.touched].tb;
      ++count;
    }
    next.push_back(warmed(params_, pup.tb, pup.exposed, count > 0 ? sum / count : 0));
  }
  for (std::size_t j = 0; j < pups_.size(); ++j) pups_[j].tb = next[j];
}

template <class Real>
void PlainEigen<Real>::predict(Pup& pup) const {
  const Real h = static_cast<Real>(params_.dt);
  const Eigen::Vector3d force(params_.drive * std::cos(pup.heading),
                              params_.drive * std::sin(pup.heading), -params_.gravity);
  const Vector gain = (params_.dt * force).cast<Real>();
  for (Point& point : pup.points) {
    point.velocity += gain;
    point.position += h * point.velocity;
  }
}

template <class Real>
Eigen::Matrix<Real, 3, 9> PlainEigen<Real>::goal_map(const Pup& pup, const Vector& centre) const {
  Eigen::Matrix<Real, 3, 9> a = Eigen::Matrix<Real, 3, 9>::Zero();
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    a += (pup.points[i].position - centre) * rest_[i].transpose();
  }
  const Eigen::Matrix<Real, 3, 3> linear = a.template leftCols<3>();
  const Eigen::JacobiSVD<Eigen::Matrix<Real, 3, 3>> svd(linear,
                                                        Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix<Real, 3, 3> u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
  const Real beta = static_cast<Real>(params_.deformation);
  Eigen::Matrix<Real, 3, 9> t = beta * (a * rest_inverse_);
  t.template leftCols<3>() += (1 - beta) * (u * svd.matrixV().transpose());
  const Real volume = std::abs(t.template leftCols<3>().determinant());
  t.template leftCols<3>() *= std::min(1 / std::cbrt(volume), Real(3));
  return t;
}

template <class Real>
void PlainEigen<Real>::match_shape(Pup& pup) const {
  Vector centre = Vector::Zero();
  for (const Point& point : pup.points) centre += point.position;
  centre /= static_cast<Real>(pup.points.size());
  const Eigen::Matrix<Real, 3, 9> t = goal_map(pup, centre);
  const Real alpha = static_cast<Real>(params_.rigidity),
             rate = static_cast<Real>(params_.rigidity / params_.dt);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    Point& point = pup.points[i];
    const Vector missing = t * rest_[i] + centre - point.position;
    point.position += alpha * missing;
    point.velocity += rate * missing;
  }
}

template <class Real>
void PlainEigen<Real>::step() {
  for (Pup& pup : pups_) floor_and_wall(pup);
  contacts();
  for (Pup& pup : pups_) steer(pup);
  warm();
  for (Pup& pup : pups_) {
    predict(pup);
    match_shape(pup);
  }
}

template <class Real>
Outcome PlainEigen<Real>::outcome() const {
  Outcome outcome;
  for (const Pup& pup : pups_) {
    for (const Point& point : pup.points) {
      append(point.position, outcome.positions);
      append(point.velocity, outcome.velocities);
    }
    outcome.body_temperature.push_back(pup.tb);
    outcome.heading.push_back(pup.heading);
    outcome.exposed.push_back(pup.exposed);
  }
  outcome.touching = touching_;
  return outcome;
}

template class PlainEigen<float>;
template class PlainEigen<double>;

}  // namespace pupflow::bench
