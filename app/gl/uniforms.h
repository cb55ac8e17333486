// Uniforms that several programs have.
#pragma once

#include "app/gl/program.h"
#include "app/view/camera.h"
#include "app/view/rgb.h"

namespace pupflow::gl {

/// Sets a color, its components as shares of 255.
void set_color(const Program& program, const char* name, view::Rgb color);

/// Uses `program` and gives it the camera.
void set_camera(const Program& program, const view::CameraMatrices& matrices);

}  // namespace pupflow::gl
