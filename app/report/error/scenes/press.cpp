// Scene 4 of the error report: two pups pressed together by their drive.
#include <cmath>

#include "app/report/error/sampling.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"
#include "engine/bodies.h"

namespace pupflow::report {
namespace {

constexpr int kSamples = 40;

Params pair() {
  Params p;
  p.pups = 2;
  p.gravity = 0;
  p.steering_gain = 0;
  p.air_conductance = 0;
  p.thermogenesis = 0;
  return p;
}

Outcome run(const Setting& setting) {
  Simulation simulation(setting.params);
  place(simulation, 0, shifted(rest_points(setting.params), {-0.31, 0, 0.7}));
  place(simulation, 1, shifted(rest_points(setting.params, oblique_rotation()), {0.31, 0, 0.73}));
  simulation.set_heading(0, 0);
  simulation.set_heading(1, std::acos(-1.0));
  simulation.set_body_temperature(0, 0.8);
  simulation.set_body_temperature(1, 0.4);
  return run_sampled(simulation, kSamples, 3, [](const LitterView& s, Trajectory& to) {
    to[0].push_back((s.positions.mean(1) - s.positions.mean(0)).norm());
    to[1].push_back(1 - s.exposed[0]);
    to[2].push_back(0.8 - s.tb[0]);
  });
}

}  // namespace

ErrorScene press_scene(bool quick) {
  ErrorScene scene;
  scene.name = "press";
  scene.title = "4. Two pups pressed together";
  scene.about =
      "Two weightless pups, 0.02 apart and one 0.03 higher, drive into each other for 0.8 s. One "
      "starts at T_b = 0.8, the other at 0.4; heat goes only from one to the other. Compared with "
      "a "
      "run with fine steps are the distance of their centres, the share of the first pup's points "
      "in contact, and the temperature that it has lost. The paths converge at about first order, "
      "from a large error: which points touch changes from step to step, and each step sets the "
      "velocities of those points. With naive refinement the displacement by contacts is also "
      "applied once a step, so pups get harder as steps get shorter.";
  scene.smallest_drawn = 1e-3;
  scene.quantities = {
      {"distance", "distance"}, {"contact", "contact area"}, {"heat", "heat exchanged"}};
  const Params p = pair();
  const int finest = quick ? 4 : 16;
  scene.curves = usual_curves(p, finest);
  scene.asides.push_back(points_aside(p, quick, {0, 1, 2}));
  scene.standard = {"dt = 0.01, predictive, double", p, 0};
  set_reference(scene, p, 256 * finest);
  scene.run = run;
  return scene;
}

}  // namespace pupflow::report
