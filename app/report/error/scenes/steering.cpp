// Scene 6 of the error report: a pup passes a fixed warm neighbour.
#include "app/report/error/sampling.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"
#include "engine/bodies.h"

namespace pupflow::report {
namespace {

constexpr int kSamples = 50;

Params passing() {
  Params p;
  p.pups = 2;
  p.gravity = 0;
  // Temperatures stay as they are set.
  p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
  p.ambient_temperature = 0.3;
  return p;
}

Outcome run(const Setting& setting) {
  Simulation simulation(setting.params);
  const Points oblique = rest_points(setting.params, oblique_rotation());
  const Points fixed = shifted(rest_points(setting.params), {0, 0, 0.7});
  place(simulation, 0, shifted(oblique, {-0.7, 0.52, 0.72}), Eigen::Vector3d(1, 0, 0));
  simulation.set_heading(0, 0);
  simulation.set_body_temperature(0, 0.4);
  simulation.set_body_temperature(1, 0.9);
  const auto hold = [&](Simulation& s) { place(s, 1, fixed); };
  hold(simulation);
  return run_sampled(
      simulation, kSamples, 2,
      [](const LitterView& s, Trajectory& to) {
        const Eigen::Vector3d centre = s.positions.mean(0);
        to[0].insert(to[0].end(), centre.data(), centre.data() + 3);
        to[1].push_back(s.heading[0]);
      },
      hold);
}

}  // namespace

ErrorScene steering_scene(bool quick) {
  ErrorScene scene;
  scene.name = "steering";
  scene.title = "6. Steering past a warm neighbour";
  scene.about =
      "A cold pup (T_b = 0.4) without weight passes a warm one (T_b = 0.9) for one second, touches "
      "it and turns towards it. The warm pup is put back into its place after every step. The "
      "path and the course θ of the cold pup are compared with a run with fine steps. Of all "
      "scenes this one converges most slowly. Contacts set velocities once a step, so the path "
      "depends on the number of steps in contact. Halving the step begins to halve the error only "
      "well below dt = 0.01/8.";
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
