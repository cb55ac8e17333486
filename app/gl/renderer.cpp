#include "app/gl/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "app/gl/uniforms.h"

namespace pupflow::gl {

namespace {

// Brightness at a sphere's outline. Its middle has exactly the color of its point.
constexpr float kEdgeShade = 0.88f;
constexpr float kFootShade = 0.6f;  // of the rim's color in the line at the slab's foot
constexpr float kUsualRows = 960;   // higher pictures have wider lines

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

/// Parts of a picture of that size, each side at most `most`.
template <class Do>
void for_each_part(int width, int height, int most, Do work) {
  for (int y = 0; y < height; y += most) {
    for (int x = 0; x < width; x += most) {
      work(Viewport{x, y, std::min(most, width - x), std::min(most, height - y)});
    }
  }
}

/// A share of `b` in `a`.
view::Rgb mixed(view::Rgb a, view::Rgb b, float share) {
  const auto mix = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(
        std::lround((1 - share) * static_cast<float>(from) + share * static_cast<float>(to)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace

/// What is drawn part by part, so that memory does not grow with size and samples.
struct Renderer::Frame {
  view::CameraMatrices matrices;
  bool from_below;
  int width, height, supersample;
  const Palette& palette;

  /// Those in which a part of the picture fills the view.
  view::CameraMatrices of(const Viewport& part) const {
    view::CameraMatrices zoomed = matrices;
    const auto zoom = [&](int row, int all, int from, int size) {
      if (size == all) return;
      const float factor = static_cast<float>(all) / static_cast<float>(size);
      const float middle =
          (2 * static_cast<float>(from) + static_cast<float>(size)) / static_cast<float>(all) - 1;
      const Eigen::Matrix4f& whole = matrices.clip_from_eye;
      zoomed.clip_from_eye.row(row) = factor * (whole.row(row) - middle * whole.row(3));
    };
    zoom(0, width, part.x, part.width);
    zoom(1, height, part.y, part.height);
    return zoomed;
  }
};

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
  const Frame frame = frame_of(camera, viewport.width, viewport.height, supersample, palette);
  draw_part(frame, {0, 0, viewport.width, viewport.height}, viewport.x, viewport.y);
}

void Renderer::draw(const view::Camera& camera, io::Image& image, int width, int height,
                    int supersample, const Palette& palette,
                    const std::function<void()>& between_parts) {
  const Frame frame = frame_of(camera, width, height, supersample, palette);
  bool begun = false;
  const auto before = [&] {
    if (begun && between_parts) between_parts();
    begun = true;
  };
  for_each_part(width, height, kLargestPart, [&](const Viewport& part) {
    picture_.resize(part.width, part.height);
    picture_.bind();
    draw_part(frame, part, 0, 0, before);
    picture_.read(image, part.x, height - part.y - part.height);
  });
}

Renderer::Frame Renderer::frame_of(const view::Camera& camera, int width, int height,
                                   int supersample, const Palette& palette) {
  line_scale_ =
      static_cast<float>(supersample) * std::max(1.0f, static_cast<float>(height) / kUsualRows);
  const view::CameraMatrices matrices =
      camera.matrices(static_cast<double>(width) / height, bounds_);
  const bool from_below = matrices.perspective ? camera.eye().z() < 0 : camera.backward().z() < 0;
  return {matrices, from_below, width, height, supersample, palette};
}

void Renderer::draw_part(const Frame& frame, const Viewport& part, int x, int y,
                         const std::function<void()>& before) {
  const int samples = frame.supersample;
  if (samples == 1) {
    if (before) before();
    draw_scene(frame.of(part), frame.from_below, {x, y, part.width, part.height}, frame.palette);
    return;
  }
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  for_each_part(
      part.width, part.height, std::max(1, kLargestPart / samples), [&](const Viewport& inner) {
        if (before) before();
        const Viewport inside{part.x + inner.x, part.y + inner.y, inner.width, inner.height};
        const Viewport store{0, 0, samples * inner.width, samples * inner.height};
        samples_.resize(store.width, store.height);
        samples_.bind();
        draw_scene(frame.of(inside), frame.from_below, store, frame.palette);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
        resolve({x + inner.x, y + inner.y, inner.width, inner.height}, samples);
      });
}

void Renderer::resolve(const Viewport& viewport, int samples) {
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glUseProgram(resolve_program_.name());
  glUniform1i(resolve_program_.uniform("samples"), 0);
  glUniform1i(resolve_program_.uniform("count"), samples);
  glUniform2i(resolve_program_.uniform("origin"), viewport.x, viewport.y);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, samples_.texture());
  glBindVertexArray(empty_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
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
  const float slab = view::kSlabDepth * arena_radius_;
  draw_rim(matrices, viewport, outside, -slab, 1, mixed(palette.slab, palette.rim, kFootShade),
           from_below ? 0 : slab);
  draw_rim(matrices, viewport, arena_radius_, 0, 0.5f, palette.rim, 0);
  draw_rim(matrices, viewport, arena_radius_, wall_height_, 1, palette.rim, 0);
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
