// The arena as the renderer draws it: floor, wall, rims.
#include "app/gl/renderer.h"
#include "app/gl/uniforms.h"

namespace pupflow::gl {

namespace {

constexpr GLint kWallSegments = 256, kPlaneSegments = 32;
constexpr float kGridShade = 0.93f;  // brightness of the lines
constexpr int kMostLines = 80;       // of a grid across the floor
constexpr float kRimWidth = 1.4f;    // pixels

}  // namespace

void Renderer::draw_floor(const view::CameraMatrices& matrices, bool from_below,
                          const Palette& palette) {
  const float outside = (1 + view::kRimWidth) * arena_radius_;
  set_camera(plane_program_, matrices);
  set_color(plane_program_, "floor_color", from_below ? palette.slab : palette.floor);
  set_color(plane_program_, "slab_color", palette.slab);
  const bool grid = !from_below && 2 * arena_radius_ < kMostLines * kGridSpacing;
  glUniform1f(plane_program_.uniform("height"), from_below ? -view::kSlabDepth * arena_radius_ : 0);
  glUniform1f(plane_program_.uniform("floor_radius"), arena_radius_);
  glUniform1f(plane_program_.uniform("outer_radius"), outside);
  glUniform1f(plane_program_.uniform("slab_depth"), view::kSlabDepth * arena_radius_);
  glUniform1f(plane_program_.uniform("spacing"), grid ? kGridSpacing : 0);
  glUniform1f(plane_program_.uniform("line_width"), line_scale_);
  glUniform1f(plane_program_.uniform("grid_shade"), kGridShade);
  glUniform1i(plane_program_.uniform("lit"), lit_ && !from_below ? 1 : 0);
  glUniform1i(plane_program_.uniform("light"), 0);
  glUniform1i(plane_program_.uniform("segments"), kPlaneSegments);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, light_.name());
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kPlaneSegments + 1));
}

void Renderer::draw_wall(const view::CameraMatrices& matrices, float radius, float bottom,
                         float top, view::Rgb color, bool glass) {
  set_camera(wall_program_, matrices);
  set_color(wall_program_, "color", color);
  glUniform1i(wall_program_.uniform("glass"), glass ? 1 : 0);
  glUniform1f(wall_program_.uniform("radius"), radius);
  glUniform1f(wall_program_.uniform("bottom"), bottom);
  glUniform1f(wall_program_.uniform("top"), top);
  glUniform1i(wall_program_.uniform("segments"), kWallSegments);
  // Of the slab, what faces the eye: behind the soft edge of the floor there is nothing.
  if (!glass) glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kWallSegments + 1));
  glCullFace(GL_BACK);
  glDisable(GL_CULL_FACE);
}

void Renderer::draw_rim(const view::CameraMatrices& matrices, const Viewport& viewport,
                        float radius, float height, float opacity, view::Rgb color, float side) {
  set_camera(rim_program_, matrices);
  set_color(rim_program_, "color", color);
  glUniform1f(rim_program_.uniform("radius"), radius);
  glUniform1f(rim_program_.uniform("height"), height);
  glUniform1f(rim_program_.uniform("opacity"), opacity);
  glUniform1f(rim_program_.uniform("side_height"), side);
  glUniform1f(rim_program_.uniform("half_width"), kRimWidth / 2 * line_scale_ + 0.5f);
  glUniform2f(rim_program_.uniform("half_viewport"), static_cast<float>(viewport.width) / 2,
              static_cast<float>(viewport.height) / 2);
  glUniform1i(rim_program_.uniform("segments"), kWallSegments);
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kWallSegments + 1));
}

}  // namespace pupflow::gl
