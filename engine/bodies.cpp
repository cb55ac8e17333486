#include "engine/bodies.h"

#include <cassert>

#include "engine/rotation.h"
#include "pupflow/geometry.h"

namespace pupflow {

std::vector<double> to_numbers(const Points& points) {
  std::vector<double> xyz;
  xyz.reserve(3 * points.size());
  for (const Eigen::Vector3d& p : points) xyz.insert(xyz.end(), {p.x(), p.y(), p.z()});
  return xyz;
}

Points to_points(std::span<const double> xyz) {
  Points points;
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
    points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  return points;
}

Points of_pup(const PointVectors& vectors, int pup) {
  Points points;
  points.reserve(static_cast<std::size_t>(vectors.points()));
  for (int i = 0; i < vectors.points(); ++i) points.push_back(vectors(pup, i));
  return points;
}

Points of_all(const PointVectors& vectors) {
  Points all;
  for (int pup = 0; pup < vectors.pups(); ++pup) {
    const Points own = of_pup(vectors, pup);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

Points rest_points(const Params& params, const Eigen::Matrix3d& rotation) {
  Points points = cube_sphere(params.face_points, params.pup_radius);
  for (Eigen::Vector3d& p : points) p = rotation * p;
  return points;
}

Points shifted(Points points, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& p : points) p += shift;
  return points;
}

void place(Simulation& simulation, int pup, const Points& points, const Points& velocities) {
  simulation.set_cloud(pup, to_numbers(points), to_numbers(velocities));
}

void place(Simulation& simulation, int pup, const Points& points, const Eigen::Vector3d& velocity) {
  place(simulation, pup, points, Points(points.size(), velocity));
}

Params weightless_pup() {
  Params params;
  params.pups = 1;
  params.gravity = 0;
  params.drive = 0;
  params.arena_radius = 1000;
  return params;
}

Pose pose_of(const Points& points, const Points& rest) {
  assert(points.size() == rest.size());
  const auto n = static_cast<double>(points.size());
  Pose pose{Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
  for (const Eigen::Vector3d& p : points) pose.centre += p / n;
  double squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    pose.map += (points[i] - pose.centre) * rest[i].transpose();
    squares += rest[i].x() * rest[i].x();
  }
  pose.map /= squares;
  pose.rotation = nearest_rotation(pose.map).matrix;
  for (std::size_t i = 0; i < points.size(); ++i) {
    pose.energy += (points[i] - pose.centre - pose.rotation * rest[i]).squaredNorm();
  }
  pose.energy /= n * rest[0].squaredNorm();
  return pose;
}

}  // namespace pupflow
