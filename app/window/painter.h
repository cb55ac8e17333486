// Paints frames into the window: of each only what it changes.
#pragma once

#include <functional>
#include <span>

#include "app/gl/target.h"
#include "app/view/rgb.h"
#include "app/window/gui.h"
#include "app/window/repaint.h"

namespace pupflow::window {

/// Holds what the window shows in a store of its own, as its images are: upside down, the upper row
/// first. So do software drivers keep windows; to copy it there they need not turn it. A context must
/// be current whenever a function here runs.
class Painter {
 public:
  /// A picture below the panels, drawn already, upside down.
  struct Image {
    const gl::Target* store;
    PixelBox place;  // as large as the store
  };

  /// Paints `images` on `paper` and over them the frame that `gui` has just ended, and copies it all
  /// to the window's framebuffer. `new_images`: the stores' pixels are not those of the last call.
  /// Returns false when the window shows all of it already.
  bool paint(Gui& gui, std::span<const Image> images, bool new_images, view::Rgb paper);

  /// The next frame is painted whole: the window lost its pixels.
  void forget() { repaint_.forget(); }

 private:
  Repaint repaint_;
  gl::Target store_{false};
  gl::WindowCopy copy_;
  float scale_ = 0, density_ = 0;  // of the fonts that were painted
};

}  // namespace pupflow::window
