// Takes pictures of litters without a display.
#pragma once

#include <memory>

#include "app/context/context.h"
#include "app/gl/renderer.h"
#include "app/io/png.h"
#include "app/pictures/graphics.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"
#include "pupflow/simulation.h"

namespace pupflow::pictures {

/// A headless context with all that a picture needs. Use it on the thread that made it.
class Studio {
 public:
  /// Throws Failure(no_context) without OpenGL, Failure(bad_input) for a bad look; prints the
  /// choice of context when `look.verbose`.
  explicit Studio(const Look& look);

  /// The litter as it stands, seen by `camera`. Throws Failure(bad_input) when the driver allows no
  /// picture of that size with the look's samples.
  io::Image shoot(const Simulation& simulation, const view::Camera& camera, int width, int height);

  const view::ColorScale& scale() const { return scale_; }

 private:
  view::ColorScale scale_;
  int supersample_;
  std::unique_ptr<context::Context> context_;  // outlives the renderer's objects
  std::unique_ptr<gl::Renderer> renderer_;
  view::DrawList list_;
};

/// The litter of `params` at t = 0, not observed. Throws Failure(bad_input) with every problem when
/// they are unsound.
Simulation unobserved_litter(const Params& params);

/// How high above the floor a framed picture looks: as high as the litter of `params` may lie once
/// it has landed, and as it starts unless that is a column that falls. Known before the first step,
/// so that the camera stands still and a frame looks the same whichever frames come with it; what
/// falls from a column comes from above the picture.
double framed_height(const Params& params);

/// The camera of `spec` framing the arena of `params`, with its litter, in a picture of that
/// aspect.
view::Camera framed_camera(const std::string& spec, const Params& params, double aspect);

/// What a picture carries beside the parameters so that it can be made again.
io::TextEntries look_entries(const Look& look);

}  // namespace pupflow::pictures
