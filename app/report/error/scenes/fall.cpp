// Scene 1 of the error report: a pup falls and lands.
#include <cmath>

#include "app/report/error/sampling.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"
#include "engine/bodies.h"

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
  place(simulation, 0, shifted(rest_points(setting.params, oblique_rotation()), {0, 0, kHeight}));
  const Points rest = rest_points(setting.params);
  return run_sampled(simulation, samples, 3, [&](const LitterView& s, Trajectory& to) {
    const Pose pose = pose_of(of_pup(s.positions, 0), rest);
    if (to[0].size() < kFalling) to[0].push_back(kHeight - pose.centre.z());
    to[1].push_back(pose.centre.z());
    to[2].push_back(pose.energy);
  });
}

void closed_form(Trajectory& right) {
  for (std::size_t i = 0; i < right[0].size(); ++i) {
    right[0][i] = 10 * std::pow(kSample * static_cast<double>(i + 1), 2) / 2;
  }
}

}  // namespace

ErrorScene fall_scene(bool quick) {
  ErrorScene scene;
  scene.name = "fall";
  scene.title = "1. Free fall and landing";
  scene.about =
      "A pup falls from 0.3 above its rest height, lands on one of its points at 0.245 s, is "
      "flattened and bounces, for 0.4 s in all. Free fall has a closed form. For height and strain "
      "(mean squared distance of the points from the undeformed pup, over r²) during the landing, "
      "the reference is a run with fine steps.";
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
