// Baseline of the pictures: the fastest frame of a litter that was found for software OpenGL (quads
// on which the spheres' outlines and depths are computed, hidden points left out), on a floor
// without rim, wall or soft edges.
#pragma once

#include "app/gl/object.h"
#include "app/gl/program.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"

namespace pupflow::bench {

/// A context must be current whenever a function here runs.
class PlainFrame {
 public:
  PlainFrame();

  /// Draws `list` into the framebuffer that is bound for drawing, one sample a pixel.
  void draw(const view::DrawList& list, const view::Camera& camera, int width, int height);

 private:
  void draw_floor(const view::CameraMatrices& matrices, float radius);
  void draw_spheres(const view::CameraMatrices& matrices, const view::DrawList& list);

  gl::Program floor_, spheres_;
  gl::VertexArray nothing_, points_;
  gl::Buffer buffer_;
};

}  // namespace pupflow::bench
