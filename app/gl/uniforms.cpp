#include "app/gl/uniforms.h"

namespace pupflow::gl {

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
  const Eigen::Matrix3f turn = matrices.eye_from_world.topLeftCorner<3, 3>();
  const Eigen::Vector3f eye = -turn.transpose() * matrices.eye_from_world.topRightCorner<3, 1>();
  glUniform3fv(program.uniform("eye"), 1, eye.data());
  const Eigen::Vector3f backward = turn.row(2);
  glUniform3fv(program.uniform("backward"), 1, backward.data());
  glUniform1i(program.uniform("perspective"), matrices.perspective ? 1 : 0);
}

}  // namespace pupflow::gl
