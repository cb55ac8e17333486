// Scene 2 of the error report: a pup turns without weight.
#include <Eigen/Geometry>
#include <cmath>

#include "app/report/error/rotations.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"

namespace pupflow::report {
namespace {

constexpr int kSamples = 50;  // one model second
const Eigen::Vector3d kSpin(0.6, 0, 0.8);

Params pup() {
  Params p;
  p.pups = 1;
  p.gravity = 0;
  p.drive = 0;
  return p;
}

void push_matrix(const Eigen::Matrix3d& matrix, std::vector<double>& to) {
  to.insert(to.end(), matrix.data(), matrix.data() + matrix.size());
}

void look(const Points& rest, const Points& points, const Points& velocities, Trajectory& to) {
  const Pose pose = pose_of(points, rest);
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    momentum += (points[i] - pose.centre).cross(velocities[i]);
  }
  to[0].insert(to[0].end(), momentum.data(), momentum.data() + 3);
  push_matrix(pose.rotation, to[1]);
  push_matrix(pose.rotation, to[2]);
}

Outcome run(const Setting& setting) {
  const Points rest = rest_points(setting.params);
  const Points offsets = rest_points(setting.params, oblique_rotation());
  Points velocities;
  for (const Eigen::Vector3d& p : offsets) velocities.push_back(kSpin.cross(p));
  const Points points = shifted(offsets, {0, 0, 0.5});
  if (setting.routine == 0) {
    Simulation simulation(setting.params);
    place(simulation, 0, points, velocities);
    return run_sampled(simulation, kSamples, 3, [&](const LitterView& s, Trajectory& to) {
      look(rest, of_pup(s.positions, 0), of_pup(s.velocities, 0), to);
    });
  }
  return run_with_rotation(setting.params, static_cast<Routine>(setting.routine - 1), points,
                           velocities, kSamples, 3,
                           [&](const Points& now, const Points& speeds, Trajectory& to) {
                             look(rest, now, speeds, to);
                           });
}

void closed_form(Trajectory& right) {
  const Params p = pup();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& q : rest_points(p, oblique_rotation())) {
    momentum += q.cross(kSpin.cross(q));
  }
  right[0].clear();
  right[2].clear();
  for (int i = 1; i <= kSamples; ++i) {
    right[0].insert(right[0].end(), momentum.data(), momentum.data() + 3);
    const Eigen::AngleAxisd turn(kSpin.norm() * kSample * i, kSpin.normalized());
    push_matrix(turn * oblique_rotation(), right[2]);
  }
}

}  // namespace

ErrorScene spin_scene(bool quick) {
  ErrorScene scene;
  scene.name = "spin";
  scene.title = "2. Free spin";
  scene.about =
      "A weightless pup turns at 1 rad/s about an oblique axis for one second. Its angular "
      "momentum should be constant. Its orientation is compared with a run of the same soft body "
      "with fine steps, and with the rotation of a rigid body. A soft body widens a little as it "
      "turns, so it turns more slowly; therefore the third error does not converge to 0.";
  scene.quantities = {{"momentum", "angular momentum"},
                      {"orientation", "orientation"},
                      {"rigid", "orientation against a rigid body's"}};
  const Params p = pup();
  const int finest = quick ? 8 : 32;
  scene.curves = usual_curves(p, finest);
  scene.asides.push_back(rotation_aside(p, {0, 1}));
  scene.standard = {"dt = 0.01, Newton, double", p, 0};
  set_reference(scene, p, 128 * finest);
  scene.run = run;
  scene.closed_form = closed_form;
  return scene;
}

}  // namespace pupflow::report
