// Scene 3 of the error report: a squeezed pup springs back.
#include <cmath>

#include "app/report/error/rotations.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"

namespace pupflow::report {
namespace {

constexpr int kSamples = 10;
constexpr double kAmplitude = 1e-4;  // small, so that the response is linear

Params pup() {
  Params p;
  p.pups = 1;
  p.gravity = 0;
  p.drive = 0;
  return p;
}

/// Three displacements of the rest offset q: a mode that the fit can represent, growth, which the
/// volume factor holds, and a mode of degree three, which the fit cannot represent.
Eigen::Vector3d displacement(int mode, const Eigen::Vector3d& q) {
  const Eigen::Vector3d u = q / pup().pup_radius;
  const double scale = kAmplitude * pup().pup_radius;
  if (mode == 0) return scale * Eigen::Vector3d(0, 0, u.x() * u.y());
  if (mode == 1) return scale * u;
  return scale * Eigen::Vector3d(u.x() * u.y() * u.z(), 0, 0);
}

/// The share of each displacement that is left; 1 at first.
void look(const Points& rest, const Points& points, Trajectory& to) {
  const Eigen::Matrix3d turn = oblique_rotation();
  const Eigen::Vector3d centre = pose_of(points, rest).centre;
  for (int mode = 0; mode < 3; ++mode) {
    double along = 0, all = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d d = displacement(mode, rest[i]);
      along += (turn.transpose() * (points[i] - centre) - rest[i]).dot(d);
      all += d.squaredNorm();
    }
    to[mode].push_back(along / all);
  }
}

Outcome run(const Setting& setting) {
  const Points rest = rest_points(setting.params);
  Points offsets;
  for (const Eigen::Vector3d& q : rest) {
    Eigen::Vector3d sum = q;
    for (int mode = 0; mode < 3; ++mode) sum += displacement(mode, q);
    offsets.emplace_back(oblique_rotation() * sum);
  }
  const Points points = shifted(offsets, {0, 0, 0.5});
  if (setting.routine == 0) {
    Simulation simulation(setting.params);
    place(simulation, 0, points);
    return run_sampled(simulation, kSamples, 3, [&](const LitterView& s, Trajectory& to) {
      look(rest, of_pup(s.positions, 0), to);
    });
  }
  const Points still(rest.size(), Eigen::Vector3d::Zero());
  return run_with_rotation(
      setting.params, static_cast<Routine>(setting.routine - 1), points, still, kSamples, 3,
      [&](const Points& now, const Points&, Trajectory& to) { look(rest, now, to); });
}

/// The solution of d'' + 2 gamma d' + (gamma^2 + omega^2) d = 0 from d = 1 at rest; engine/
/// refinement.h.
double response(double alpha, double t) {
  const double gamma = -std::log(1 - alpha) / (2 * kReferenceStep);
  const double omega = std::acos(std::sqrt(1 - alpha)) / kReferenceStep;
  return std::exp(-gamma * t) * (std::cos(omega * t) + gamma / omega * std::sin(omega * t));
}

void closed_form(Trajectory& right) {
  const Params p = pup();
  const double alpha[] = {p.rigidity * (1 - p.deformation), p.rigidity, p.rigidity};
  for (std::size_t mode = 0; mode < 3; ++mode) {
    for (std::size_t i = 0; i < right[mode].size(); ++i) {
      right[mode][i] = response(alpha[mode], kSample * static_cast<double>(i + 1));
    }
  }
}

}  // namespace

ErrorScene squeeze_scene(bool quick) {
  ErrorScene scene;
  scene.name = "squeeze";
  scene.title = "3. A squeezed pup springs back";
  scene.about =
      "A weightless pup is deformed a little in three ways at once and released: bent in a mode "
      "that the quadratic fit can represent, enlarged, and deformed in a mode that the fit cannot "
      "represent. Each amplitude should follow the damped oscillator to which consistent "
      "refinement converges (docs/model.md, Refining the time step). Naive refinement keeps α, so "
      "each halving of the step makes the body stiffer, and it converges to another motion. The "
      "explicit integrator has another limit, too: an oscillator without damping. The deformations "
      "are 10⁻⁴ of the radius, so the closed form has a relative error of about 10⁻⁴, and single "
      "precision resolves only three digits of them. The exact amplitude decays to 0, so errors "
      "are divided by the amplitude at first.";
  scene.smallest_drawn = 1e-4;
  scene.quantities = {{"bend", "bend (fitted)", 1},
                      {"growth", "growth (volume)", 1},
                      {"ripple", "ripple (not fitted)", 1}};
  const Params p = pup();
  const int finest = quick ? 16 : 128;
  scene.curves = usual_curves(p, finest);
  scene.asides.push_back(rotation_aside(p, {0, 1, 2}));
  scene.standard = {"dt = 0.01, Newton, double", p, 0};
  set_reference(scene, p, 1);
  scene.reference.label = "the closed form of the linear response";
  scene.run = run;
  scene.closed_form = closed_form;
  return scene;
}

}  // namespace pupflow::report
