// Which points of two near pups may touch, and the memory for comparing them.
//
//   pup a, pup b     their boxes are near: broad_phase.h
//        |
//   balls_meet       the balls round them, too
//        |
//   near points      those of a in the box and the ball of b, within reach; then those of b near
//        |           the box round these and in the ball of a
//   contacts         the kernels touch_nearest and touch_sums (kernels.h)
#pragma once

#include <cstdint>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/state.h"

namespace pupflow {

/// Whether the balls round two pups come within `reach`, up to rounding.
template <class Real>
bool balls_meet(const Bounds<Real>& a, const Bounds<Real>& b, Real reach);

/// The points of one pup that are near another, and their contacts with it.
template <class Real>
struct NearPoints {
  AlignedVector<Real> numbers;  // memory of the arrays of Real below
  std::vector<int> point;
  std::vector<std::uint64_t> touching;
  Candidates<Real> candidates;
  CandidateContacts<Real> contacts;
  void make_room(int stride);
};

/// Memory for comparing the points of a pair.
template <class Real>
struct Comparison {
  AlignedVector<float> rough;
  AlignedVector<int> list;
  std::vector<std::uint8_t> met;
  AlignedVector<Real> tiles;
  void make_room(int stride);
  TouchMemory<Real> memory();
};

/// Copies the points of either pup that may touch the other. Both must have room. False if there
/// are none.
template <class Real>
bool find_near_points(const State<Real>& state, NearPair pair, Real reach, NearPoints<Real>& first,
                      NearPoints<Real>& second);

}  // namespace pupflow
