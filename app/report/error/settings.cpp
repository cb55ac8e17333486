#include "app/report/error/settings.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pupflow::report {
namespace {

std::string step_label(int parts) {
  return parts == 1 ? "dt = 0.01" : "dt = 0.01/" + std::to_string(parts);
}

}  // namespace

Eigen::Matrix3d oblique_rotation() {
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
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

void set_reference(ErrorScene& scene, const Params& params, int parts) {
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
              "dt = 0.01, with k points along a face edge, compared with " + many.label + ".",
              many,
              {},
              std::move(quantities)};
  for (const int k : {3, 4, 5, 7, 9, 11, 15}) aside.settings.push_back(with(k));
  return aside;
}

}  // namespace pupflow::report
