// Scene 1 of the error report: a pup falls and lands.
#include <cmath>

#include "app/report/error/pups.h"
#include "app/report/error/scenes/scenes.h"

namespace pupflow::report {
namespace {

constexpr double kHeight = 0.6;  // of the centre, at first; it lands at about 0.3
constexpr int kFalling = 12;     // samples before the lowest point reaches the floor, at 0.245 s

Params pup() {
  Params p;
  p.pups = 1;
  p.drive = 0;
  return p;
}

Outcome run(const Setting& setting, int samples) {
  Simulation simulation(setting.params);
  const Points offsets = rest_points(setting.params, oblique_rotation());
  place(simulation, 0, {0, 0, kHeight}, offsets, Points(offsets.size(), Eigen::Vector3d::Zero()));
  return run_sampled(simulation, samples, 3, [](const Simulation& s, Trajectory& to) {
    const Pose pose = pose_of(s, 0);
    if (to[0].size() < kFalling) to[0].push_back(kHeight - pose.centre.z());
    to[1].push_back(pose.centre.z());
    to[2].push_back(pose.strain);
  });
}

void closed_form(Trajectory& right) {
  for (std::size_t i = 0; i < right[0].size(); ++i) {
    right[0][i] = 10 * std::pow(kSample * static_cast<double>(i + 1), 2) / 2;
  }
}

}  // namespace

Scene fall_scene(bool quick) {
  Scene scene;
  scene.name = "fall";
  scene.title = "1. Free fall and landing";
  scene.about =
      "A pup falls from 0.3 above its rest height, lands on one of its points at 0.245 s, is "
      "flattened and bounces, for 0.4 s in all. Free fall has a closed form; height and strain "
      "(mean squared distance of the points from the undeformed pup, over r²) across the landing "
      "have a fine run for an answer.";
  scene.quantities = {
      {"fall", "depth fallen before landing"}, {"height", "height"}, {"strain", "strain"}};
  const Params p = pup();
  const int finest = quick ? 8 : 32;
  scene.curves = usual_curves(p, finest);
  scene.asides.push_back(points_aside(p, quick, {1, 2}));
  scene.standard = {"dt = 0.01, predictive, double", p, 0};
  set_reference(scene, p, 128 * finest);
  scene.run = [](const Setting& s) { return run(s, 20); };
  scene.closed_form = closed_form;
  return scene;
}

}  // namespace pupflow::report
