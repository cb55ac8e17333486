// Scene 6 of the error report: a pup passes a fixed warm neighbour.
#include "app/report/error/pups.h"
#include "app/report/error/scenes/scenes.h"

namespace pupflow::report {
namespace {

constexpr int kSamples = 50;

Params passing() {
  Params p;
  p.pups = 2;
  p.gravity = 0;
  p.air_conductance = p.contact_conductance = p.thermogenesis =
      0;  // temperatures stay as they are set
  p.ambient_temperature = 0.3;
  return p;
}

Outcome run(const Setting& setting) {
  Simulation simulation(setting.params);
  const Points upright = rest_points(setting.params, Eigen::Matrix3d::Identity());
  const Points oblique = rest_points(setting.params, oblique_rotation());
  const Points still(upright.size(), Eigen::Vector3d::Zero());
  const Points moving(upright.size(), Eigen::Vector3d(1, 0, 0));
  const Eigen::Vector3d fixed(0, 0, 0.7);
  place(simulation, 0, {-0.7, 0.52, 0.72}, oblique, moving);
  simulation.set_heading(0, 0);
  simulation.set_body_temperature(0, 0.4);
  simulation.set_body_temperature(1, 0.9);
  const auto hold = [&](Simulation& s) { place(s, 1, fixed, upright, still); };
  hold(simulation);
  return run_sampled(
      simulation, kSamples, 2,
      [](const Simulation& s, Trajectory& to) {
        const Eigen::Vector3d centre = s.centre(0);
        to[0].insert(to[0].end(), centre.data(), centre.data() + 3);
        to[1].push_back(s.heading()[0]);
      },
      hold);
}

}  // namespace

Scene steering_scene(bool quick) {
  Scene scene;
  scene.name = "steering";
  scene.title = "6. Steering past a warm neighbour";
  scene.about =
      "A cold pup (T_b = 0.4) passes a warm one (0.9) that is put back into its place after every "
      "step, grazes it and turns towards it, for one second, without weight. Held against a fine "
      "run: its path and its course θ. This is the scene that converges worst. Contacts set "
      "velocities once a step, so while the pups graze each other the path depends on how often "
      "that happens; only well below dt = 0.01/8 does halving the step begin to halve the error.";
  scene.smallest_drawn = 1e-3;
  scene.quantities = {{"path", "path"}, {"course", "course"}};
  const Params p = passing();
  const int finest = quick ? 4 : 16;
  scene.curves = usual_curves(p, finest);
  scene.asides.push_back(points_aside(p, quick, {0, 1}));
  scene.standard = {"dt = 0.01, predictive, double", p, 0};
  set_reference(scene, p, 256 * finest);
  scene.run = run;
  return scene;
}

}  // namespace pupflow::report
