#include "app/gl/renderer.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "app/gl/uniforms.h"

namespace pupflow::gl {

namespace {

// Brightness at a sphere's outline. Its middle has exactly the color of its point.
constexpr float kEdgeShade = 0.88f;
constexpr std::size_t kKeptBytes = std::size_t{32} << 20;  // of a picture whose store stays
constexpr float kUsualRows = 960;                          // higher pictures have wider lines

/// Where the attributes of a vertex lie in the bound buffer, for the bound vertex array.
struct Layout {
  GLsizei stride;
  GLuint divisor;  // 0: one a vertex; 1: one an instance

  void floats(GLuint attribute, GLint count, std::size_t offset) const {
    set(attribute, count, GL_FLOAT, offset);
  }
  void bytes(GLuint attribute, GLint count, std::size_t offset) const {  // as shares of 255
    set(attribute, count, GL_UNSIGNED_BYTE, offset);
  }

 private:
  void set(GLuint attribute, GLint count, GLenum type, std::size_t offset) const {
    // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    glVertexAttribPointer(attribute, count, type, GL_TRUE, stride,
                          reinterpret_cast<const void*>(offset));
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, divisor);
  }
};

/// How the bound vertex array finds view::Vertex in the bound buffer, one a vertex or an instance.
void lay_out_vertices(GLuint divisor) {
  const Layout layout{sizeof(view::Vertex), divisor};
  layout.floats(0, 3, 0);
  layout.bytes(1, 4, offsetof(view::Vertex, r));
}

/// The same of view::Ellipsoid.
void lay_out_ellipsoids() {
  using view::Ellipsoid;
  const Layout layout{sizeof(Ellipsoid), 1};
  layout.floats(0, 3, offsetof(Ellipsoid, centre));
  layout.floats(1, 3, offsetof(Ellipsoid, shape));
  layout.floats(2, 3, offsetof(Ellipsoid, shape) + 3 * sizeof(float));
  layout.bytes(3, 4, offsetof(Ellipsoid, color));
  layout.bytes(4, 3, offsetof(Ellipsoid, sky));
  layout.bytes(5, 3, offsetof(Ellipsoid, sky) + 4);
  layout.bytes(6, 3, offsetof(Ellipsoid, key));
  layout.bytes(7, 3, offsetof(Ellipsoid, key) + 4);
  layout.floats(8, 1, offsetof(Ellipsoid, radius));
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

void Renderer::Mesh::draw() const {
  glBindVertexArray(array.name());
  glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
}

Renderer::Renderer(const std::string& shader_dir)
    : spheres_program_(shader_dir, "spheres.vert", "spheres.frag"),
      sphere_edges_program_(shader_dir, "spheres.vert", "sphere_edges.frag"),
      ellipsoids_program_(shader_dir, "ellipsoids.vert", "ellipsoids.frag"),
      skin_program_(shader_dir, "skin.vert", "skin.frag"),
      plane_program_(shader_dir, "plane.vert", "plane.frag"),
      wall_program_(shader_dir, "wall.vert", "wall.frag"),
      rim_program_(shader_dir, "rim.vert", "rim.frag"),
      resolve_program_(shader_dir, "resolve.vert", "resolve.frag") {
  glBindVertexArray(spheres_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, spheres_buffer_.name());
  lay_out_vertices(1);
  glBindVertexArray(ellipsoids_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, ellipsoids_buffer_.name());
  lay_out_ellipsoids();
}

void Renderer::upload(const view::DrawList& list) {
  fill(GL_ARRAY_BUFFER, spheres_buffer_, list.spheres());
  fill(GL_ARRAY_BUFFER, ellipsoids_buffer_, list.ellipsoids());
  count_ = static_cast<GLsizei>(list.spheres().size());
  ellipsoids_count_ = static_cast<GLsizei>(list.ellipsoids().size());
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
  if (!soft_) draw_ellipsoids(matrices, viewport.height);
  draw_wall(matrices, outside, -view::kSlabDepth * arena_radius_, 0, palette.slab, false);

  // Then what covers pixels in part.
  glEnable(GL_BLEND);
  draw_floor(matrices, from_below, palette);
  if (soft_) draw_ellipsoids(matrices, viewport.height);  // furthest first
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

void Renderer::draw_ellipsoids(const view::CameraMatrices& matrices, int rows) {
  if (ellipsoids_count_ == 0) return;
  const Program& program = ellipsoids_program_;
  set_camera(program, matrices);
  const Eigen::Matrix3f turn = matrices.eye_from_world.topLeftCorner<3, 3>();
  const Eigen::Vector3f eye = -turn.transpose() * matrices.eye_from_world.topRightCorner<3, 1>();
  glUniform3fv(program.uniform("eye"), 1, eye.data());
  const Eigen::Vector3f backward = turn.row(2);
  glUniform3fv(program.uniform("backward"), 1, backward.data());
  glUniform1f(program.uniform("pixel"),
              2 / (matrices.clip_from_eye(1, 1) * static_cast<float>(rows)));
  glUniform1i(program.uniform("soft"), soft_ ? 1 : 0);
  const view::LightModel& light = view::light_model();
  const Eigen::Vector3f lamp = view::key_light();
  glUniform3fv(program.uniform("lamp"), 1, lamp.data());
  glUniform3f(program.uniform("strengths"), light.key, light.sky, light.floor);
  glUniform3f(program.uniform("limits"), light.full, light.least, light.low_sky);
  glUniform1f(program.uniform("gamma"), view::LightModel::kGamma);
  glBindVertexArray(ellipsoids_array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, ellipsoids_count_);
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
