#include "bench/floors.h"

#include <algorithm>

#include "bench/litter_state.h"
#include "bench/measure.h"
#include "engine/broad_phase.h"
#include "engine/lanes.h"
#include "engine/near.h"
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

/// Whether point i of `a` touches one of the points begin ... end - 1 of `b`.
template <class Real>
bool touches_one(const Candidates<Real>& a, int i, const Candidates<Real>& b, int begin, int end,
                 Real reach) {
  for (int j = begin; j < end; ++j) {
    const Real dx = a.x[i] - b.x[j], dy = a.y[i] - b.y[j], dz = a.z[i] - b.z[j];
    if (dx * dx + dy * dy + dz * dz < reach * reach) return true;
  }
  return false;
}

}  // namespace

template <class Real>
TightLitter<Real>::TightLitter(const Snapshot& snapshot)
    : params_(snapshot.params), state_(state_of<Real>(snapshot)) {
  const auto rest = cube_sphere(params_.face_points, params_.pup_radius);
  cloud_ = make_cloud<Real>(rest);
  for (int j = 0; j < state_.pups; ++j) {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Zero();
    for (int i = 0; i < state_.points; ++i) {
      const std::size_t from = 3 * (state_.flat(j) + i);
      linear += Eigen::Vector3d(snapshot.positions.data() + from) * rest[i].transpose();
    }
    linear_.push_back(linear);
  }
  for (int first = 0; first < state_.pups; ++first) {
    for (int second = first + 1; second < state_.pups; ++second) {
      Near a = near(first, second), b = near(second, first);
      if (a.count > 0 && b.count > 0) pairs_.emplace_back(std::move(a), std::move(b));
    }
  }
}

template <class Real>
TightPup<Real> TightLitter<Real>::pup(int number) {
  const std::size_t row = state_.row(number);
  State<Real>& s = state_;
  return {{s.x.data() + row, s.y.data() + row, s.z.data() + row},
          {s.vx.data() + row, s.vy.data() + row, s.vz.data() + row},
          s.stride};
}

template <class Real>
typename TightLitter<Real>::Near TightLitter<Real>::near(int number, int other) const {
  Near near;
  const double reach = 2 * params_.point_radius;
  const Bounds<Real>& box = state_.bounds[other];
  const std::size_t row = state_.row(number);
  for (std::size_t i = row; i < row + state_.points; ++i) {
    const Real place[3] = {state_.x[i], state_.y[i], state_.z[i]};
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const auto x = static_cast<double>(place[axis]);
      inside = inside && x > box.low[axis] - reach && x < box.high[axis] + reach;
    }
    if (!inside) continue;
    near.x.push_back(place[0]);
    near.y.push_back(place[1]);
    near.z.push_back(place[2]);
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
auto TightLitter<Real>::least_search(int group) const -> LeastSearch {
  const auto reach = static_cast<Real>(2 * params_.point_radius);
  NearPoints<Real> first, second;
  first.make_room(state_.stride);
  second.make_room(state_.stride);
  LeastSearch least;
  BroadPhase<Real> broad_phase;
  for (const NearPair& pair : broad_phase.near_pairs(state_.bounds, reach)) {
    if (!balls_meet(state_.bounds[pair.first], state_.bounds[pair.second], reach)) continue;
    least.pups += 2;
    if (!find_near_points(state_, pair, reach, first, second)) continue;
    const Candidates<Real>&a = first.candidates, &b = second.candidates;
    for (int begin = 0; begin < b.count; begin += group) {
      const int end = std::min(begin + group, b.count);
      for (int i = 0; i < a.count; ++i) {
        if (touches_one(a, i, b, begin, end, reach)) least.points += group;
      }
    }
  }
  return least;
}

template <class Real>
Floors TightLitter<Real>::measure(const TightKernels<Real>& kernels) {
  const auto each = [&](auto&& work) {
    for (int j = 0; j < state_.pups; ++j) work(pup(j));
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
