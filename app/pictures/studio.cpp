#include "app/pictures/studio.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/context/headless.h"
#include "app/io/failure.h"
#include "app/io/text.h"
#include "pupflow/geometry.h"

namespace pupflow::pictures {

namespace {

constexpr int kMostSamples = 8;

int checked_samples(int supersample) {
  if (supersample < 1 || supersample > kMostSamples) {
    throw io::Failure(io::ExitCode::bad_input, "the samples across a pixel must be 1 ... " +
                                                   std::to_string(kMostSamples) + ", not " +
                                                   std::to_string(supersample));
  }
  return supersample;
}

}  // namespace

Studio::Studio(const Look& look)
    : scale_(look.colormap, look.scale_min, look.scale_max),
      supersample_(checked_samples(look.supersample)) {
  context::ContextReport report;
  context_ = context::make_headless(report);
  if (look.verbose) {
    for (const std::string& line : report.tried) std::cerr << "OpenGL: " << line << '\n';
    std::cerr << "OpenGL: " << report.renderer << ", " << report.version << '\n';
  }
  renderer_ = std::make_unique<gl::Renderer>(look.shader_dir);
}

io::Image Studio::shoot(const Simulation& simulation, const view::Camera& camera, int width,
                        int height) {
  list_.update(simulation, scale_, camera);
  renderer_->upload(list_);
  return renderer_->picture(camera, width, height, supersample_);
}

Simulation unobserved_litter(const Params& params) {
  std::string problems;
  for (const Problem& problem : check(params)) {
    problems += (problems.empty() ? "" : "; ") + problem.message;
  }
  if (!problems.empty()) throw io::Failure(io::ExitCode::bad_input, problems);
  Simulation simulation(params);
  simulation.set_observed(false);
  return simulation;
}

double framed_height(const Params& params) {
  const double reach = params.pup_radius + params.point_radius;
  constexpr double kFilled = 0.45;  // the share of the room that bodies in a heap take up
  const double share_of_floor = std::pow(reach / params.arena_radius, 2);
  const double bodies = params.pups * 4.0 / 3.0 * reach * share_of_floor;
  double height = std::max(2 * reach, bodies / kFilled);
  const bool falls_from_afar = params.start == Start::column && params.gravity > 0;
  if (falls_from_afar) return height;
  for (const Eigen::Vector3d& centre : start_centres(params)) {
    height = std::max(height, centre.z() + reach);
  }
  return height;
}

view::Camera framed_camera(const std::string& spec, const Params& params, double aspect) {
  view::Camera camera = view::Camera::parse(spec);
  const double radius = params.arena_radius * (1 + view::kRimWidth);
  camera.frame(radius, framed_height(params), aspect);
  return camera;
}

io::TextEntries look_entries(const Look& look) {
  return {{"colormap", look.colormap},
          {"scale", io::number_text(look.scale_min) + "," + io::number_text(look.scale_max)},
          {"supersample", std::to_string(look.supersample)}};
}

}  // namespace pupflow::pictures
