#include "bench/plain_frame.h"

#include <cstddef>

namespace pupflow::bench {
namespace {

constexpr int kSegments = 128;

void use(const gl::Program& program, const view::CameraMatrices& matrices) {
  glUseProgram(program.name());
  glUniformMatrix4fv(program.uniform("eye_from_world"), 1, GL_FALSE,
                     matrices.eye_from_world.data());
  glUniformMatrix4fv(program.uniform("clip_from_eye"), 1, GL_FALSE, matrices.clip_from_eye.data());
}

}  // namespace

PlainFrame::PlainFrame()
    : floor_(PUPFLOW_BENCH_FOLDER, "plain_floor.vert", "plain_floor.frag"),
      spheres_("", "spheres.vert", "spheres.frag") {
  glBindVertexArray(points_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  constexpr GLsizei kStride = sizeof(view::Vertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, nullptr);
  // OpenGL wants the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto* colors = reinterpret_cast<const void*>(offsetof(view::Vertex, r));
  glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, colors);
  for (const GLuint attribute : {0u, 1u}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
}

void PlainFrame::draw_floor(const view::CameraMatrices& matrices, float radius) {
  use(floor_, matrices);
  glUniform3f(floor_.uniform("color"), 0.89f, 0.89f, 0.9f);
  glUniform1f(floor_.uniform("outer_radius"), radius);
  glUniform1i(floor_.uniform("segments"), kSegments);
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLE_FAN, 0, kSegments + 2);
}

void PlainFrame::draw_spheres(const view::CameraMatrices& matrices, const view::DrawList& list) {
  use(spheres_, matrices);
  glUniform1i(spheres_.uniform("perspective"), matrices.perspective ? 1 : 0);
  glUniform1f(spheres_.uniform("radius"), list.sphere_radius());
  glUniform1f(spheres_.uniform("edge_shade"), 0.45f);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.spheres().size_bytes()),
               list.spheres().data(), GL_STREAM_DRAW);
  glBindVertexArray(points_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(list.spheres().size()));
}

void PlainFrame::draw(const view::DrawList& list, const view::Camera& camera, int width,
                      int height) {
  glViewport(0, 0, width, height);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  const view::CameraMatrices matrices =
      camera.matrices(static_cast<double>(width) / height, list.bounds());
  draw_floor(matrices, list.arena_radius());
  draw_spheres(matrices, list);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace pupflow::bench
