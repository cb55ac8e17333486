// Helpers for tests that set up and look at litters.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::testing {

using Points = std::vector<Eigen::Vector3d>;

inline Points to_points(const std::vector<double>& xyz) {
  Points points;
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
    points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  return points;
}

inline std::vector<double> to_numbers(const Points& points) {
  std::vector<double> xyz;
  for (const Eigen::Vector3d& p : points) xyz.insert(xyz.end(), {p.x(), p.y(), p.z()});
  return xyz;
}

inline Points all_positions(const Simulation& s) {
  std::vector<double> xyz(3 * static_cast<std::size_t>(s.pups()) * s.points());
  s.view().positions.copy_to(xyz);
  return to_points(xyz);
}

inline Points all_velocities(const Simulation& s) {
  std::vector<double> xyz(3 * static_cast<std::size_t>(s.pups()) * s.points());
  s.view().velocities.copy_to(xyz);
  return to_points(xyz);
}

inline Points of_pup(const Simulation& s, int pup, const Points& all) {
  return Points(all.begin() + static_cast<std::ptrdiff_t>(pup) * s.points(),
                all.begin() + static_cast<std::ptrdiff_t>(pup + 1) * s.points());
}

inline void place(Simulation& s, int pup, const Points& positions, const Points& velocities) {
  s.set_cloud(pup, to_numbers(positions), to_numbers(velocities));
}

/// One pup, far from floor and wall, that nothing pushes.
inline Params weightless() {
  Params p;
  p.pups = 1;
  p.gravity = 0;
  p.drive = 0;
  p.arena_radius = 1000;
  return p;
}

}  // namespace pupflow::testing
