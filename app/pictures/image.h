// A picture of a litter in memory, for who steps the litter.
#pragma once

#include "app/io/png.h"
#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "pupflow/view.h"

namespace pupflow::pictures {

struct ImageJob {
  int width = 1280, height = 960;
  view::Camera camera = view::Camera::parse(view::Camera::kUsual);
  bool bar = true;  // draw the legend of the colors
  Look look;        // its shaders are those of the first job
};

/// The litter as it is now. The OpenGL context is made by the first call and kept. Calls from
/// several threads take turns. Throws Failure: no_context, bad_input.
io::Image image(const ImageJob& job, const LitterView& litter);

}  // namespace pupflow::pictures
