#include "app/gl/renderer.h"

#include <cstddef>
#include <span>

namespace pupflow::gl {

namespace {

// Brightness at a sphere's outline. Its middle has exactly the color of the bar.
constexpr float kEdgeShade = 0.45f;
constexpr GLint kWallSegments = 256, kPlaneSegments = 32;

void set_color(const Program& program, view::Rgb color) {
  glUniform3f(program.uniform("color"), static_cast<float>(color.r) / 255,
              static_cast<float>(color.g) / 255, static_cast<float>(color.b) / 255);
}

void set_camera(const Program& program, const view::CameraMatrices& matrices) {
  glUseProgram(program.name());
  glUniformMatrix4fv(program.uniform("eye_from_world"), 1, GL_FALSE,
                     matrices.eye_from_world.data());
  glUniformMatrix4fv(program.uniform("clip_from_eye"), 1, GL_FALSE, matrices.clip_from_eye.data());
  glUniform1i(program.uniform("perspective"), matrices.perspective ? 1 : 0);
}

}  // namespace

Renderer::Renderer(const std::string& shader_dir)
    : spheres_program_(shader_dir, "spheres.vert", "spheres.frag"),
      plane_program_(shader_dir, "plane.vert", "plane.frag"),
      wall_program_(shader_dir, "wall.vert", "wall.frag"),
      resolve_program_(shader_dir, "resolve.vert", "resolve.frag") {
  glBindVertexArray(spheres_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, spheres_buffer_.name());
  constexpr GLsizei kStride = sizeof(view::Sphere);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, nullptr);
  // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto* colors = reinterpret_cast<const void*>(offsetof(view::Sphere, r));
  glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, colors);
  for (const GLuint attribute : {0u, 1u}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
}

void Renderer::upload(const view::DrawList& list) {
  const std::span<const view::Sphere> spheres = list.spheres();
  glBindBuffer(GL_ARRAY_BUFFER, spheres_buffer_.name());
  // A fresh store each time: the driver need not wait for the last frame's.
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(spheres.size_bytes()), spheres.data(),
               GL_STREAM_DRAW);
  count_ = static_cast<GLsizei>(spheres.size());
  sphere_radius_ = list.sphere_radius();
  arena_radius_ = list.arena_radius();
  bounds_ = list.bounds();
}

void Renderer::draw(const view::Camera& camera, const Viewport& viewport, int supersample,
                    const Palette& palette) {
  if (supersample == 1) {
    draw_scene(camera, viewport, palette);
    return;
  }
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const Viewport all{0, 0, supersample * viewport.width, supersample * viewport.height};
  samples_.resize(all.width, all.height);
  samples_.bind();
  draw_scene(camera, all, palette);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));

  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glUseProgram(resolve_program_.name());
  glUniform1i(resolve_program_.uniform("samples"), 0);
  glUniform1i(resolve_program_.uniform("count"), supersample);
  glUniform2i(resolve_program_.uniform("origin"), viewport.x, viewport.y);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, samples_.texture());
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

io::Image Renderer::picture(const view::Camera& camera, int width, int height, int supersample,
                            const Palette& palette) {
  picture_.resize(width, height);
  picture_.bind();
  draw(camera, {0, 0, width, height}, supersample, palette);
  return picture_.read();
}

void Renderer::draw_scene(const view::Camera& camera, const Viewport& viewport,
                          const Palette& palette) {
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glEnable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(static_cast<float>(palette.background.r) / 255,
               static_cast<float>(palette.background.g) / 255,
               static_cast<float>(palette.background.b) / 255, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  const double aspect = static_cast<double>(viewport.width) / viewport.height;
  const view::CameraMatrices matrices = camera.matrices(aspect, bounds_);
  const float outside = (1 + view::kRimWidth) * arena_radius_;
  const float top = view::kRimHeight * arena_radius_, bottom = -view::kRimDepth * arena_radius_;
  // The floor reaches under the rim, so that no gap shows between two soft edges.
  draw_plane(matrices, 0, -1, (arena_radius_ + outside) / 2, palette.floor);
  draw_wall(matrices, arena_radius_, 0, top, palette.rim);
  draw_wall(matrices, outside, bottom, top, palette.rim);
  draw_spheres(matrices);
  draw_plane(matrices, top, arena_radius_, outside, palette.rim);
  glDisable(GL_DEPTH_TEST);
}

void Renderer::draw_plane(const view::CameraMatrices& matrices, float height, float inner_radius,
                          float outer_radius, view::Rgb color) {
  set_camera(plane_program_, matrices);
  set_color(plane_program_, color);
  glUniform1f(plane_program_.uniform("height"), height);
  glUniform1f(plane_program_.uniform("inner_radius"), inner_radius);
  glUniform1f(plane_program_.uniform("outer_radius"), outer_radius);
  glUniform1i(plane_program_.uniform("segments"), kPlaneSegments);
  glBindVertexArray(empty_array_.name());
  glEnable(GL_BLEND);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kPlaneSegments + 1));
  glDisable(GL_BLEND);
}

void Renderer::draw_wall(const view::CameraMatrices& matrices, float radius, float bottom,
                         float top, view::Rgb color) {
  set_camera(wall_program_, matrices);
  set_color(wall_program_, color);
  glUniform1f(wall_program_.uniform("radius"), radius);
  glUniform1f(wall_program_.uniform("bottom"), bottom);
  glUniform1f(wall_program_.uniform("top"), top);
  glUniform1i(wall_program_.uniform("segments"), kWallSegments);
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kWallSegments + 1));
}

void Renderer::draw_spheres(const view::CameraMatrices& matrices) {
  set_camera(spheres_program_, matrices);
  glUniform1f(spheres_program_.uniform("radius"), sphere_radius_);
  glUniform1f(spheres_program_.uniform("edge_shade"), kEdgeShade);
  glBindVertexArray(spheres_array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace pupflow::gl
