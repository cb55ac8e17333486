// How a picture of one litter is laid out: the scene, and the colour bar in a strip beside it.
#pragma once

#include "app/io/png.h"
#include "app/view/color_bar.h"
#include "app/view/colormap.h"
#include "app/view/text.h"

namespace pupflow::pictures {

/// The sides that a picture may have, in pixels.
constexpr int kSmallestSide = 16, kLargestSide = 16384;

/// The layout of a picture of `width` x `height` pixels, with or without a colour bar.
class Frame {
 public:
  /// Throws Failure(bad_input) when a side is out of range or the bar leaves no room for the scene.
  Frame(int width, int height, bool bar);

  /// The scene's part of the picture, from its left edge; it is as tall as the picture.
  int scene_width() const { return scene_width_; }
  int height() const { return height_; }
  double scene_aspect() const { return static_cast<double>(scene_width_) / height_; }

  /// The whole picture around `scene`, which has the size said above; the bar marks `tp`.
  io::Image compose(io::Image scene, const view::ColorScale& scale, double tp);

 private:
  int width_, height_;
  bool bar_;
  view::ColorBarStyle style_;
  view::ColorBarMargins margins_;
  int bar_width_ = 0, scene_width_ = 0;
  view::TextPainter text_;
};

}  // namespace pupflow::pictures
