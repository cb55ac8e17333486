#include "app/report/stability/maps.h"

#include <algorithm>
#include <cmath>

#include "app/report/report.h"
#include "app/report/stability/axes.h"
#include "app/report/stability/heat.h"

namespace pupflow::report {
namespace {

// The two panels of a map.
const std::vector<Method> kIntegrators{
    {"predictive", [](Params& p) { p.integrator = Integrator::predictive; }},
    {"explicit", [](Params& p) { p.integrator = Integrator::explicit_; }}};
const std::vector<Method> kRefinements{
    {"naive", [](Params& p) { p.refinement = Refinement::naive; }},
    {"consistent", [](Params& p) { p.refinement = Refinement::consistent; }}};
const std::vector<Method> kContacts{
    {"nearest", [](Params& p) { p.contact = ContactRule::nearest; }},
    {"sum", [](Params& p) { p.contact = ContactRule::sum; }}};
const std::vector<Method> kHeatRules{{"exact", [](Params& p) { p.heat = HeatRule::exact; }},
                                     {"euler", [](Params& p) { p.heat = HeatRule::euler; }}};

/// The default litter.
Params litter(bool quick) {
  Params params;
  params.steps = quick ? 500 : 1500;
  return params;
}

/// Weightless pups, for the maps of heat.
Params heat_alone(int pups) {
  Params params;
  params.pups = pups;
  params.gravity = params.drive = 0;
  params.steps = 400;
  return params;
}

std::string number(double value) {
  return rounded(value, 6);
}

// A mode of deformation that the fit can represent is multiplied by |lambda| = sqrt(1 - alpha (1 -
// beta)) in each predictive step, all others by sqrt(1 - alpha).
constexpr double kSlow = 0.98, kQuick = 0.9;

StabilityMap alpha_beta(bool quick) {
  StabilityMap map;
  map.name = "alpha_beta";
  map.title = "α × β";
  map.words =
      "A mode of deformation that the fit can represent is multiplied by |λ| = √(1 − α (1 − β)) in "
      "each predictive step; with |λ| = 0.98 it falls to 1/e in 50 steps. In explicit steps |λ| = "
      "1 for any α and β.";
  map.x = along("alpha", "rigidity α", false,
                quick ? Values{0.1, 0.7, 1}
                      : Values{0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1});
  map.y = along("beta", "deformation β", false,
                quick ? Values{0, 0.5, 0.9, 1}
                      : Values{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 1});
  map.methods = kIntegrators;
  map.base = litter(quick);
  for (const double size : {kSlow, kQuick}) {
    map.lines.push_back(
        {"|λ| = √(1 − α (1 − β)) = " + number(size), "1 - " + number(1 - size * size) + " / x"});
  }
  return map;
}

TheoryLine escape_line(const Params& params) {
  return {"f h = 2/3: the wall cannot hold the drive", "", 2 / (3 * params.drive)};
}

StabilityMap step_alpha(bool quick) {
  StabilityMap map;
  map.name = "step_alpha";
  map.title = "h × α";
  map.words =
      "α acts per step, so |λ| does not depend on h: its lines are horizontal. With a larger h a "
      "body falls further, and is driven further, in each step.";
  map.x = step_axis(quick);
  map.y = alpha_axis(quick);
  map.methods = kIntegrators;
  map.base = litter(quick);
  for (const double size : {kSlow, kQuick}) {
    map.lines.push_back({"|λ| = √(1 − α (1 − β)) = " + number(size),
                         number((1 - size * size) / (1 - map.base.deformation)), 0, 0});
  }
  map.lines.push_back({"g h² = r_{pup}: a step falls a radius", "",
                       std::sqrt(map.base.pup_radius / map.base.gravity)});
  map.lines.push_back(escape_line(map.base));
  return map;
}

StabilityMap step_gravity(bool quick) {
  StabilityMap map;
  map.name = "step_gravity";
  map.title = "h × gravity";
  map.words =
      "The floor acts once a step. Where a body falls more than a radius in a step, g h² > r_pup, "
      "all its points can be below the floor, which flattens it. Where both h and g are small the "
      "run ends before the litter has landed.";
  map.x = step_axis(quick);
  map.y = along("gravity", "gravity g", true, quick ? Values{0.1, 10, 1e5} : decades(-1, 5, 2));
  map.methods = kIntegrators;
  map.base = litter(quick);
  map.lines = {{"g h² = r_{pup}: a step falls a radius", number(map.base.pup_radius) + " / x**2"},
               escape_line(map.base)};
  return map;
}

StabilityMap step_refinement(bool quick) {
  StabilityMap map;
  map.name = "step_refinement";
  map.title = "h × α, refined";
  map.words =
      "With naive refinement α is per step, so a smaller step makes the body stiffer. With "
      "consistent refinement α is per 0.01 s, so the body stays the same "
      "([equations](../../model.md#refining-the-time-step)). Consistent refinement is refused "
      "where α = 1 and h < 0.01, and for h > 0.01.";
  map.x = along("dt", "time step h", true,
                quick ? Values{0.0025, 0.005, 0.01} : Values{0.001, 0.0025, 0.005, 0.01});
  map.y = alpha_axis(quick);
  map.methods = kRefinements;
  map.base = litter(quick);
  const double size = kSlow;
  map.lines = {{"naive: |λ| = √(1 − α (1 − β)) = " + number(size),
                number((1 - size * size) / (1 - map.base.deformation)), 0, 0}};
  return map;
}

StabilityMap drive_pups(bool quick) {
  StabilityMap map;
  map.name = "drive_pups";
  map.title = "drive × N";
  map.words =
      "In each step the wall sets the outward velocity to v ← (v − 1)/2, then the drive adds f h, "
      "so outside the wall v converges to 2 f h − 1. With f > 2/(3 h) that is above 1/3, and the "
      "pup moves away from the wall.";
  map.x = along("drive", "drive f", true, quick ? Values{1, 10, 1000} : decades(-1, 3, 3));
  map.y = pups_axis(quick);
  map.methods = kIntegrators;
  map.base = litter(quick);
  map.lines = {{"f h = 2/3: the wall cannot hold the drive", "", 2 / (3 * map.base.dt)}};
  return map;
}

StabilityMap points(bool quick) {
  StabilityMap map;
  map.name = "points";
  map.title = "k × r_point / r_pup";
  map.words =
      "A pup has 6 k² points, and two points touch when they are closer than 2 r_point. The "
      "smaller "
      "r_point is, the smaller is the displacement by a contact. With `contact = sum` the "
      "displacements of a point add up over its contacts, so many large points displace each other "
      "by more than shape matching can restore.";
  map.x = along("face_points", "points along a face edge k", false,
                quick ? Values{2, 4, 7} : Values{2, 3, 4, 5, 6, 7, 8, 10});
  map.y = point_axis(quick);
  map.methods = kContacts;
  map.base = litter(quick);
  return map;
}

StabilityMap radii(bool quick) {
  StabilityMap map;
  map.name = "radii";
  map.title = "r_pup / r_arena × N";
  map.words =
      "The arena has the radius 2, and r_point / r_pup is 0.2. The model has a length scale of its "
      "own, since a displacement by contact is a length squared: small pups are softer. Large "
      "pups do not fit beside each other and lie on top of each other.";
  map.x = pup_axis(quick);
  map.y = along("pups", "pups N", true, quick ? Values{1, 4, 12} : Values{1, 2, 4, 6, 12, 24});
  map.methods = kContacts;
  map.base = litter(quick);
  return map;
}

StabilityMap step_k1(bool quick) {
  StabilityMap map;
  map.name = "step_k1";
  map.title = "h × k₁, heat alone";
  map.words =
      "One pup without contact (A = 1), from T_b(0) to T_a + G/k₁. Forward Euler multiplies the "
      "difference by 1 − k₁ h: for k₁ h > 1 it changes its sign in every step, for k₁ h > 2 it "
      "grows. The exact solution multiplies it by e^(−k₁ h). The result does not depend on the "
      "seed, so one run is enough.";
  map.x = step_axis(quick);
  map.y = along("k1", "conductance to the air k₁", true,
                quick ? Values{0.9, 15, 150, 1500} : decades(-1, 4, 4));
  map.methods = kHeatRules;
  map.base = heat_alone(1);
  map.classify = try_heat;
  map.seeds = 1;
  map.lines = {{"k₁ h = 1", "1 / x", 0, 1}, {"k₁ h = 2", "2 / x", 0, 1}};
  return map;
}

StabilityMap step_k2(bool quick) {
  StabilityMap map;
  map.name = "step_k2";
  map.title = "h × k₂, heat alone";
  map.x = step_axis(quick);
  map.y = along("k2", "conductance to others k₂", true,
                quick ? Values{1, 15, 150, 1500} : decades(-1, 4, 4));
  map.methods = kHeatRules;
  map.base = heat_alone(2);
  map.base.air_conductance = map.base.thermogenesis = 0;
  map.classify = try_exchange;
  map.seeds = 1;
  const double contact = held_contact(map.base);
  map.words =
      "Two pups that are held together, 1 − A = " + rounded(contact) +
      ", with k₁ = G = 0. The T_b of each tends to that of the other at the beginning of the step, "
      "so with κ = k₂ (1 − A) h forward Euler multiplies their difference by 1 − 2 κ, and the "
      "exact solution of a step by 2 e^(−κ) − 1. The latter is negative for κ > ln 2, so the "
      "difference changes its sign, but it never grows. With more pups in contact the factor is "
      "not below −1 either. The result does not depend on the seed, so one run is enough.";
  map.lines = {{"κ = ln 2", number(std::log(2) / contact) + " / x", 0, 0},
               {"κ = 1/2", number(0.5 / contact) + " / x", 0, 1},
               {"κ = 1", number(1 / contact) + " / x", 0, 1}};
  return map;
}

}  // namespace

std::vector<StabilityMap> stability_maps(bool quick) {
  return {alpha_beta(quick),      step_alpha(quick), step_gravity(quick),
          step_refinement(quick), drive_pups(quick), points(quick),
          radii(quick),           step_k1(quick),    step_k2(quick)};
}

Params cell_params(const StabilityMap& map, const Method& method, double x, double y,
                   std::int64_t seed) {
  Params params = map.base;
  params.seed = seed;
  method.set(params);
  map.x.set(params, x);
  map.y.set(params, y);
  if (map.classify != try_litter) return params;
  // With small steps the run is long enough for the litter to land.
  constexpr double kSeconds = 8;
  const std::int64_t most = 2 * map.base.steps;
  const auto needed = static_cast<std::int64_t>(std::min(kSeconds / params.dt, 1e9));
  params.steps = std::max(params.steps, std::min(needed, most));
  return params;
}

}  // namespace pupflow::report
