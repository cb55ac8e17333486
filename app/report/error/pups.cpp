#include "app/report/error/pups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ctime>

#include "engine/rotation.h"
#include "pupflow/geometry.h"

namespace pupflow::report {
namespace {

std::vector<double> numbers(const Points& points) {
  std::vector<double> xyz;
  for (const Eigen::Vector3d& p : points) xyz.insert(xyz.end(), {p.x(), p.y(), p.z()});
  return xyz;
}

Points part_of(const Simulation& simulation, int pup, const std::vector<double>& xyz) {
  Points points;
  const std::size_t n = simulation.points(), first = n * static_cast<std::size_t>(pup);
  for (std::size_t i = first; i < first + n; ++i) {
    points.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
  }
  return points;
}

std::vector<double> room(const Simulation& simulation) {
  return std::vector<double>(3 * static_cast<std::size_t>(simulation.pups()) * simulation.points());
}

/// What reading the clock adds to a time.
double clock_seconds() {
  double least = 1;
  for (int i = 0; i < 100; ++i) {
    const double begin = thread_seconds();
    least = std::min(least, thread_seconds() - begin);
  }
  return least;
}

std::string step_label(int parts) {
  return parts == 1 ? "dt = 0.01" : "dt = 0.01/" + std::to_string(parts);
}

}  // namespace

Eigen::Matrix3d oblique_rotation() {
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

Points rest_points(const Params& params, const Eigen::Matrix3d& rotation) {
  Points points = cube_sphere(params.face_points, params.pup_radius);
  for (Eigen::Vector3d& p : points) p = rotation * p;
  return points;
}

void place(Simulation& simulation, int pup, const Eigen::Vector3d& centre, const Points& offsets,
           const Points& velocities) {
  Points points = offsets;
  for (Eigen::Vector3d& p : points) p += centre;
  simulation.set_cloud(pup, numbers(points), numbers(velocities));
}

Points points_of(const Simulation& simulation, int pup) {
  std::vector<double> xyz = room(simulation);
  simulation.copy_positions(xyz);
  return part_of(simulation, pup, xyz);
}

Points velocities_of(const Simulation& simulation, int pup) {
  std::vector<double> xyz = room(simulation);
  simulation.copy_velocities(xyz);
  return part_of(simulation, pup, xyz);
}

Pose pose_of(const Simulation& simulation, int pup) {
  const Params& params = simulation.params();
  const Points now = points_of(simulation, pup);
  const Points rest = rest_points(params, Eigen::Matrix3d::Identity());
  Pose pose{Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0};
  for (const Eigen::Vector3d& p : now) pose.centre += p / static_cast<double>(now.size());
  Eigen::Matrix3d fit = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < now.size(); ++i) fit += (now[i] - pose.centre) * rest[i].transpose();
  pose.rotation = nearest_rotation(fit).matrix;
  for (std::size_t i = 0; i < now.size(); ++i) {
    pose.strain += (now[i] - pose.centre - pose.rotation * rest[i]).squaredNorm();
  }
  pose.strain /= static_cast<double>(now.size()) * params.pup_radius * params.pup_radius;
  return pose;
}

double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Outcome run_sampled(Simulation& simulation, int samples, std::size_t quantities, const Look& look,
                    const std::function<void(Simulation&)>& between) {
  const auto steps = static_cast<int>(std::lround(kSample / simulation.params().dt));
  const double clock = between ? clock_seconds() : 0;
  Outcome outcome;
  outcome.samples.resize(quantities);
  double spent = 0;
  const auto step = [&](int count) {
    const double begin = thread_seconds();
    for (int k = 0; k < count && outcome.status.ok(); ++k) outcome.status = simulation.step();
    spent += thread_seconds() - begin - clock;
  };
  for (int i = 0; i < samples && outcome.status.ok(); ++i) {
    stop_if_interrupted();
    if (!between) step(steps);
    for (int k = 0; between && k < steps && outcome.status.ok(); ++k) {
      step(1);
      between(simulation);
    }
    look(simulation, outcome.samples);
  }
  outcome.seconds = spent / (samples * kSample);
  return outcome;
}

Setting refined(const Params& params, int parts) {
  Setting setting{step_label(parts), params, 0};
  setting.params.dt = kReferenceStep / parts;
  setting.params.refinement = Refinement::consistent;
  return setting;
}

std::vector<Setting> halved(const Params& params, int finest) {
  std::vector<Setting> settings;
  for (int parts = 1; parts <= finest; parts *= 2) settings.push_back(refined(params, parts));
  return settings;
}

std::vector<Setting> halved_naively(const Params& params, int finest) {
  std::vector<Setting> settings{{"dt = 0.02", params, 0}};
  settings[0].params.dt = 2 * kReferenceStep;
  for (Setting setting : halved(params, finest)) {
    setting.params.refinement = Refinement::naive;
    settings.push_back(setting);
  }
  return settings;
}

std::vector<Curve> usual_curves(const Params& params, int finest) {
  // The engine refuses finer ones in float, whose rounding would push the pups.
  constexpr int kFinestFloat = 64;
  Params narrow = params, undamped = params;
  narrow.precision = Precision::float_;
  undamped.integrator = Integrator::explicit_;
  return {{"consistent", halved(params, finest), true},
          {"naive", halved_naively(params, finest), false},
          {"consistent in float", halved(narrow, std::min(finest, kFinestFloat)), false},
          {"explicit", halved(undamped, finest), false}};
}

void set_reference(Scene& scene, const Params& params, int parts) {
  scene.finer = refined(params, 2 * parts);
  scene.reference = refined(params, parts);
  for (Setting* setting : {&scene.finer, &scene.reference}) {
    setting->params.precision = Precision::double_;
  }
  scene.reference.label = "a run in double with a step of 0.01/" + std::to_string(2 * parts);
}

Aside points_aside(const Params& params, bool quick, std::vector<std::size_t> quantities) {
  const auto with = [&](int k) {
    Setting setting{"k = " + std::to_string(k), params, 0};
    setting.params.face_points = k;
    return setting;
  };
  const Setting many = with(quick ? 20 : kMaxFacePoints);
  Aside aside{"points",
              "Points a pup",
              "dt = 0.01, with k points along a face edge, held against " + many.label + ".",
              many,
              {},
              std::move(quantities)};
  for (const int k : {3, 4, 5, 7, 9, 11, 15}) aside.settings.push_back(with(k));
  return aside;
}

}  // namespace pupflow::report
