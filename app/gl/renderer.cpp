#include "app/gl/renderer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pupflow::gl {

namespace {

// Brightness at a sphere's outline. Its middle has exactly the color of its point.
constexpr float kEdgeShade = 0.88f;
constexpr GLint kWallSegments = 256, kPlaneSegments = 32;
constexpr float kGridShade = 0.93f;                        // brightness of the lines
constexpr std::size_t kKeptBytes = std::size_t{32} << 20;  // of a picture whose store stays
constexpr int kMostLines = 80;                             // of a grid across the floor
constexpr float kUsualRows = 960;                          // higher pictures have wider lines
constexpr float kRimWidth = 1.4f;                          // pixels

void set_color(const Program& program, const char* name, view::Rgb color) {
  glUniform3f(program.uniform(name), static_cast<float>(color.r) / 255,
              static_cast<float>(color.g) / 255, static_cast<float>(color.b) / 255);
}

void set_camera(const Program& program, const view::CameraMatrices& matrices) {
  glUseProgram(program.name());
  glUniformMatrix4fv(program.uniform("eye_from_world"), 1, GL_FALSE,
                     matrices.eye_from_world.data());
  glUniformMatrix4fv(program.uniform("clip_from_eye"), 1, GL_FALSE, matrices.clip_from_eye.data());
  const Eigen::Matrix4f clip_from_world = matrices.clip_from_eye * matrices.eye_from_world;
  glUniformMatrix4fv(program.uniform("clip_from_world"), 1, GL_FALSE, clip_from_world.data());
  glUniform1i(program.uniform("perspective"), matrices.perspective ? 1 : 0);
}

/// How the bound vertex array finds view::Vertex in the bound buffer, one a vertex or an instance.
void lay_out_vertices(GLuint divisor) {
  constexpr GLsizei kStride = sizeof(view::Vertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, nullptr);
  // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto* colors = reinterpret_cast<const void*>(offsetof(view::Vertex, r));
  glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, colors);
  for (const GLuint attribute : {0u, 1u}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, divisor);
  }
}

/// A fresh store each time: the driver need not wait for the last frame's.
template <class Element>
void fill(GLenum target, const Buffer& buffer, std::span<const Element> content) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(content.size_bytes()), content.data(),
               GL_STREAM_DRAW);
}

}  // namespace

Renderer::Mesh::Mesh() {
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
  lay_out_vertices(0);
  glBindVertexArray(0);
}

void Renderer::Mesh::upload(const view::Triangles& triangles) {
  glBindVertexArray(array.name());
  fill(GL_ARRAY_BUFFER, vertices, std::span(triangles.vertices));
  fill(GL_ELEMENT_ARRAY_BUFFER, indices, std::span(triangles.indices));
  glBindVertexArray(0);
  count = static_cast<GLsizei>(triangles.indices.size());
}

/// By parts: llvmpipe fails where one has some 2^25 corners, and between them another context draws.
void Renderer::Mesh::draw() const {
  constexpr GLsizei kPart = 3 << 15;
  glBindVertexArray(array.name());
  for (GLsizei first = 0; first < count; first += kPart) {
    const auto offset = static_cast<std::uintptr_t>(first) * sizeof(std::uint32_t);
    // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    glDrawElements(GL_TRIANGLES, std::min(kPart, count - first), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
    if (first + kPart < count) glFlush();
  }
}

Renderer::Renderer(const std::string& shader_dir)
    : spheres_program_(shader_dir, "spheres.vert", "spheres.frag"),
      sphere_edges_program_(shader_dir, "spheres.vert", "sphere_edges.frag"),
      skin_program_(shader_dir, "skin.vert", "skin.frag"),
      plane_program_(shader_dir, "plane.vert", "plane.frag"),
      wall_program_(shader_dir, "wall.vert", "wall.frag"),
      rim_program_(shader_dir, "rim.vert", "rim.frag"),
      resolve_program_(shader_dir, "resolve.vert", "resolve.frag") {
  glBindVertexArray(spheres_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, spheres_buffer_.name());
  lay_out_vertices(1);
}

void Renderer::upload(const view::DrawList& list) {
  fill(GL_ARRAY_BUFFER, spheres_buffer_, list.spheres());
  count_ = static_cast<GLsizei>(list.spheres().size());
  skin_.upload(list.skin());
  outline_.upload(list.outline());
  soft_ = list.drawing().quality != view::Quality::fast;
  const view::FloorLight& floor = list.floor();
  lit_ = floor.size > 0;
  if (lit_) {
    glBindTexture(GL_TEXTURE_2D, light_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, floor.size, floor.size, 0, GL_RED, GL_UNSIGNED_BYTE,
                 floor.texels.data());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    }
  }
  sphere_radius_ = list.sphere_radius();
  arena_radius_ = list.arena_radius();
  wall_height_ = list.wall_height();
  bounds_ = list.bounds();
}

void Renderer::draw(const view::Camera& camera, const Viewport& viewport, int supersample,
                    const Palette& palette) {
  line_scale_ = static_cast<float>(supersample) *
                std::max(1.0f, static_cast<float>(viewport.height) / kUsualRows);
  const double aspect = static_cast<double>(viewport.width) / viewport.height;
  const view::CameraMatrices matrices = camera.matrices(aspect, bounds_);
  const bool from_below = matrices.perspective ? camera.eye().z() < 0 : camera.backward().z() < 0;
  if (supersample == 1) {
    draw_scene(matrices, from_below, viewport, palette);
    return;
  }
  // Part by part, so that memory does not grow with the samples.
  const int part = std::max(1, kLargestPart / supersample);
  for (int y = 0; y < viewport.height; y += part) {
    for (int x = 0; x < viewport.width; x += part) {
      const Viewport inside{x, y, std::min(part, viewport.width - x),
                            std::min(part, viewport.height - y)};
      draw_part(matrices, from_below, viewport, inside, supersample, palette);
    }
  }
}

void Renderer::draw_part(const view::CameraMatrices& whole, bool from_below,
                         const Viewport& viewport, const Viewport& inside, int supersample,
                         const Palette& palette) {
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  // Clip coordinates in which the part fills the view.
  view::CameraMatrices matrices = whole;
  const auto zoom = [&](int row, int all, int from, int size) {
    const float factor = static_cast<float>(all) / static_cast<float>(size);
    const float middle =
        (2 * static_cast<float>(from) + static_cast<float>(size)) / static_cast<float>(all) - 1;
    matrices.clip_from_eye.row(row) =
        factor * (whole.clip_from_eye.row(row) - middle * whole.clip_from_eye.row(3));
  };
  zoom(0, viewport.width, inside.x, inside.width);
  zoom(1, viewport.height, inside.y, inside.height);
  const Viewport samples{0, 0, supersample * inside.width, supersample * inside.height};
  samples_.resize(samples.width, samples.height);
  samples_.bind();
  draw_scene(matrices, from_below, samples, palette);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));

  const int x = viewport.x + inside.x, y = viewport.y + inside.y;
  glViewport(x, y, inside.width, inside.height);
  glUseProgram(resolve_program_.name());
  glUniform1i(resolve_program_.uniform("samples"), 0);
  glUniform1i(resolve_program_.uniform("count"), supersample);
  glUniform2i(resolve_program_.uniform("origin"), x, y);
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
  io::Image image = picture_.read();
  if (image.rgba.size() > kKeptBytes) picture_ = Target();
  return image;
}

void Renderer::draw_scene(const view::CameraMatrices& matrices, bool from_below,
                          const Viewport& viewport, const Palette& palette) {
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glEnable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const view::Rgb& paper = palette.background;
  if (palette.transparent) {
    glClearColor(0, 0, 0, 0);
  } else {
    glClearColor(static_cast<float>(paper.r) / 255, static_cast<float>(paper.g) / 255,
                 static_cast<float>(paper.b) / 255, 1);
  }
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  const float outside = (1 + view::kRimWidth) * arena_radius_;
  // Bodies first: where they are, nothing of the floor is worked out.
  set_camera(skin_program_, matrices);
  glEnable(GL_CULL_FACE);
  skin_.draw();
  glDisable(GL_CULL_FACE);
  draw_spheres(matrices, viewport.height);
  draw_wall(matrices, outside, -view::kSlabDepth * arena_radius_, 0, palette.slab, false);

  // Then what covers pixels in part.
  glEnable(GL_BLEND);
  draw_floor(matrices, from_below, palette);
  glDepthMask(GL_FALSE);
  draw_soft_edges(matrices);
  draw_wall(matrices, arena_radius_, 0, wall_height_, palette.glass, true);
  const float bottom = -view::kSlabDepth * arena_radius_;
  draw_rim(matrices, viewport, outside, bottom, 0.6f, palette.rim);
  draw_rim(matrices, viewport, arena_radius_, 0, 0.5f, palette.rim);
  draw_rim(matrices, viewport, arena_radius_, wall_height_, 1, palette.rim);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

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
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kWallSegments + 1));
}

void Renderer::draw_rim(const view::CameraMatrices& matrices, const Viewport& viewport,
                        float radius, float height, float opacity, view::Rgb color) {
  set_camera(rim_program_, matrices);
  set_color(rim_program_, "color", color);
  glUniform1f(rim_program_.uniform("radius"), radius);
  glUniform1f(rim_program_.uniform("height"), height);
  glUniform1f(rim_program_.uniform("opacity"), opacity);
  glUniform1f(rim_program_.uniform("half_width"), kRimWidth / 2 * line_scale_ + 0.5f);
  glUniform2f(rim_program_.uniform("half_viewport"), static_cast<float>(viewport.width) / 2,
              static_cast<float>(viewport.height) / 2);
  glUniform1i(rim_program_.uniform("segments"), kWallSegments);
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kWallSegments + 1));
}

void Renderer::draw_spheres(const view::CameraMatrices& matrices, int rows) {
  if (count_ == 0) return;
  for (const Program* program : {&sphere_edges_program_, &spheres_program_}) {
    set_camera(*program, matrices);
    glUniform1f(program->uniform("radius"), sphere_radius_);
    glUniform1f(program->uniform("edge_shade"), kEdgeShade);
    glUniform1f(program->uniform("pixel"),
                2 / (matrices.clip_from_eye(1, 1) * static_cast<float>(rows)));
    glUniform1f(program->uniform("shrink"), soft_ ? 0.5f : 0);
    glUniform1f(program->uniform("margin"), program == &spheres_program_ ? 0 : 1);
  }
  glBindVertexArray(spheres_array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

void Renderer::draw_soft_edges(const view::CameraMatrices& matrices) {
  if (!soft_) return;
  set_camera(skin_program_, matrices);
  outline_.draw();
  if (count_ == 0) return;
  glUseProgram(sphere_edges_program_.name());  // its uniforms are those of draw_spheres
  glBindVertexArray(spheres_array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace pupflow::gl
