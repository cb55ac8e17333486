// Litters and pictures for tests of the renderer.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/gl/renderer.h"
#include "pupflow/simulation.h"
#include "tests/pictures/gl_test.h"

namespace pupflow::gl {

using Vector = Eigen::Vector3d;
using view::Camera;
using view::Rgb;

inline constexpr double kDegrees = std::numbers::pi / 180;
inline const view::ColorScale kJet("jet", 0,
                                   1);  // pure blue at 0, pure red at 1: shading keeps the hue

using RendererTest = GlTest;

/// A litter in which every point of a pup sits at one place: each pup is one sphere.
inline Simulation spheres(const std::vector<Vector>& centres, double radius) {
  Params params;
  params.pups = static_cast<int>(centres.size());
  params.face_points = 2;
  params.point_radius = radius;
  Simulation simulation(params);
  for (int pup = 0; pup < simulation.pups(); ++pup) {
    std::vector<double> cloud;
    for (int i = 0; i < simulation.points(); ++i) {
      const Vector& c = centres[static_cast<std::size_t>(pup)];
      cloud.insert(cloud.end(), {c.x(), c.y(), c.z()});
    }
    simulation.set_cloud(pup, cloud, std::vector<double>(cloud.size(), 0.0));
    simulation.set_body_temperature(pup, pup % 2 == 0 ? 0.0 : 1.0);
  }
  return simulation;
}

inline constexpr view::Drawing kPoints{.draw = view::Draw::points, .quality = view::Quality::fast};
inline constexpr view::Drawing kAllPoints{
    .draw = view::Draw::points, .quality = view::Quality::fast, .culling = view::Culling::none};

inline io::Image take_picture(const Simulation& simulation, const view::ColorScale& scale,
                              const Camera& camera, int width, int height, int supersample,
                              view::Drawing drawing = kPoints) {
  view::DrawList list;
  drawing.rows = height * supersample;
  list.update(simulation, scale, camera, drawing);
  Renderer renderer;
  renderer.upload(list);
  return renderer.picture(camera, width, height, supersample);
}

}  // namespace pupflow::gl
