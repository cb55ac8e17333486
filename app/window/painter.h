// Paints frames into the window: of each, where the window can do so, only what it changes.
#pragma once

#include <array>
#include <span>

#include "app/context/glfw_window.h"
#include "app/gl/target.h"
#include "app/view/rgb.h"
#include "app/window/gui.h"
#include "app/window/repaint.h"

namespace pupflow::window {

/// For one window, whose context must be current whenever a function here runs.
///
/// A software driver that has GLX_MESA_copy_sub_buffer keeps what was painted last time; then boxes
/// are painted and shown, and a frame that changes nothing costs no pixel. Elsewhere each frame is
/// painted whole.
class Painter {
 public:
  /// A part of a picture below the panels, drawn already.
  struct Image {
    const gl::SharedPicture* picture;
    PixelBox place;
    int left = 0, top = 0;  // of the part in the picture
  };

  /// `slow_gl`: the processor draws.
  Painter(const context::GlfwWindow& window, bool slow_gl);

  /// Shows `images` on `paper` and over them the frame that `gui` has just ended. `new_images`: the
  /// pictures are not those of the last call.
  void paint(Gui& gui, std::span<const Image> images, bool new_images, view::Rgb paper);

  /// Whether what was shown last must be painted again: the window had just got another size.
  bool unsettled() const { return copy_box_ != nullptr && swaps_ > 0; }

  /// The window lost its pixels.
  void forget() { repaint_.forget(); }

 private:
  void clear(std::span<const PixelBox> boxes, std::span<const PixelBox> images, int height,
             view::Rgb paper) const;
  void show(std::span<const PixelBox> boxes, int width, int height);

  const context::GlfwWindow& window_;
  void (*copy_box_)(void* display, unsigned long drawable, int x, int y, int width,
                    int height) = nullptr;  // to the screen; null: the window shows whole frames
  void* display_ = nullptr;
  unsigned long drawable_ = 0;
  Repaint repaint_;
  std::array<float, 2> size_{};    // of the window in the last frame
  int swaps_ = 0;                  // frames still to be swapped as a whole
  float scale_ = 0, density_ = 0;  // of the fonts that were painted
};

}  // namespace pupflow::window
