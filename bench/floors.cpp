#include "bench/floors.h"

#include <algorithm>

#include "bench/measure.h"
#include "engine/lanes.h"
#include "engine/rotation.h"
#include "pupflow/geometry.h"

namespace pupflow::bench {
namespace {

constexpr int kRepeats = 200;
constexpr double kFarAway = 1e18;  // padding that is near nobody

/// Keeps the compiler from leaving out work whose result nobody needs.
template <class T>
void keep(T&& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

template <class Work>
double median_time(Work work) {
  std::vector<double> times;
  times.reserve(kRepeats);
  for (int i = 0; i < kRepeats; ++i) times.push_back(microseconds(work));
  return median(std::move(times));
}

}  // namespace

template <class Real>
TightLitter<Real>::TightLitter(const Snapshot& state)
    : params_(state.params), pups_(static_cast<int>(state.body_temperature.size())) {
  const auto rest = cube_sphere(params_.face_points, params_.pup_radius);
  cloud_ = make_cloud<Real>(rest);
  for (auto& values : axis_) values.resize(static_cast<std::size_t>(pups_) * cloud_.stride);
  for (int j = 0; j < pups_; ++j) {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Zero();
    for (int i = 0; i < cloud_.stride; ++i) {
      const int point = std::min(i, cloud_.points - 1);
      const std::size_t from = 3 * (static_cast<std::size_t>(j) * cloud_.points + point);
      const std::size_t to = static_cast<std::size_t>(j) * cloud_.stride + i;
      for (int axis = 0; axis < 3; ++axis) {
        axis_[axis][to] = static_cast<Real>(state.positions[from + axis]);
        axis_[axis + 3][to] = static_cast<Real>(state.velocities[from + axis]);
      }
      if (i == point) {
        linear += Eigen::Vector3d(state.positions.data() + from) * rest[point].transpose();
      }
    }
    linear_.push_back(linear);
    measure_box(j);
  }
  for (int first = 0; first < pups_; ++first) {
    for (int second = first + 1; second < pups_; ++second) {
      Near a = near(first, second), b = near(second, first);
      if (a.count > 0 && b.count > 0) pairs_.emplace_back(std::move(a), std::move(b));
    }
  }
}

template <class Real>
TightPup<Real> TightLitter<Real>::pup(int number) {
  TightPup<Real> pup{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t row = static_cast<std::size_t>(number) * cloud_.stride;
    pup.position[axis] = axis_[axis].data() + row;
    pup.velocity[axis] = axis_[axis + 3].data() + row;
  }
  pup.count = cloud_.stride;
  return pup;
}

template <class Real>
void TightLitter<Real>::measure_box(int number) {
  Box box{};
  const TightPup<Real> points = pup(number);
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax_element(points.position[axis], points.position[axis] + points.count);
    box.low[axis] = static_cast<double>(*low);
    box.high[axis] = static_cast<double>(*high);
  }
  boxes_.push_back(box);
}

template <class Real>
typename TightLitter<Real>::Near TightLitter<Real>::near(int number, int other) const {
  Near near;
  const double reach = 2 * params_.point_radius;
  const std::size_t row = static_cast<std::size_t>(number) * cloud_.stride;
  for (std::size_t i = row; i < row + cloud_.points; ++i) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = static_cast<double>(axis_[axis][i]);
      inside =
          inside && x > boxes_[other].low[axis] - reach && x < boxes_[other].high[axis] + reach;
    }
    if (!inside) continue;
    near.x.push_back(axis_[0][i]);
    near.y.push_back(axis_[1][i]);
    near.z.push_back(axis_[2][i]);
  }
  near.count = static_cast<int>(near.x.size());
  for (auto* values : {&near.x, &near.y, &near.z}) {
    values->resize(padded<Real>(near.count), static_cast<Real>(kFarAway));
  }
  return near;
}

template <class Real>
double TightLitter<Real>::distance_tests() const {
  double tests = 0;
  for (const auto& [a, b] : pairs_) tests += static_cast<double>(a.count) * b.count;
  return tests;
}

template <class Real>
Floors TightLitter<Real>::measure(const TightKernels<Real>& kernels) {
  const auto each = [&](auto&& work) {
    for (int j = 0; j < pups_; ++j) work(pup(j));
  };
  Floors floors;
  const Real none[3] = {0, 0, 0};
  floors.predict = median_time(
      [&] { each([&](const TightPup<Real>& p) { kernels.predict(p, none, Real(0)); }); });
  floors.match = median_time([&] {
    each([&](const TightPup<Real>& p) { kernels.match(p, cloud_.mode.data(), Real(0), Real(0)); });
  });
  floors.bounds = median_time([&] {
    each([&](const TightPup<Real>& p) {
      Real low[3], high[3];
      keep(kernels.bounds(p, low, high));
    });
  });
  std::vector<Rotation> rotations(linear_.size());
  floors.rotations = median_time([&] {
    nearest_rotations(linear_, rotations.data());
    keep(rotations);
  });
  const auto reach = static_cast<Real>(2 * params_.point_radius);
  floors.distances = median_time([&] {
    for (const auto& [a, b] : pairs_) {
      const Real* const of_a[3] = {a.x.data(), a.y.data(), a.z.data()};
      const Real* const of_b[3] = {b.x.data(), b.y.data(), b.z.data()};
      keep(kernels.near_pairs(of_a, a.count, of_b, padded<Real>(b.count), reach * reach));
    }
  });
  return floors;
}

template class TightLitter<float>;
template class TightLitter<double>;

}  // namespace pupflow::bench
