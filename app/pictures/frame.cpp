#include "app/pictures/frame.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/gl/renderer.h"
#include "app/io/failure.h"
#include "app/view/canvas.h"

namespace pupflow::pictures {

Frame::Frame(int width, int height, bool bar)
    : width_(width),
      height_(height),
      bar_(bar),
      style_{.text_size = std::clamp(height / 48.0, 9.0, 64.0)},
      margins_(view::color_bar_margins(style_)),
      bar_width_(static_cast<int>(std::lround(1.3 * style_.text_size))) {
  for (const int side : {width, height}) {
    if (side < kSmallestSide || side > kLargestSide) {
      throw io::Failure(io::ExitCode::bad_input,
                        "a picture's sides must be " + std::to_string(kSmallestSide) + " ... " +
                            std::to_string(kLargestSide) + " pixels, not " + std::to_string(width) +
                            "x" + std::to_string(height));
    }
  }
  const int gap = static_cast<int>(style_.text_size);
  const int strip = margins_.left + bar_width_ + margins_.right + gap;
  scene_width_ = bar ? width - strip : width;
  if (scene_width_ < kSmallestSide) {
    throw io::Failure(io::ExitCode::bad_input, "a picture " + std::to_string(width) +
                                                   " pixels wide has no room for the colour bar");
  }
}

io::Image Frame::compose(io::Image scene, const view::ColorScale& scale, double tp) {
  if (!bar_) return scene;
  io::Image frame(width_, height_);
  view::fill(frame, {0, 0, width_, height_}, gl::Palette{}.background);
  view::blit(frame, scene, 0, 0);
  const int inset = height_ / 8;
  const view::Box bar{scene_width_ + margins_.left, inset, bar_width_, height_ - 2 * inset};
  view::draw_color_bar(frame, text_, bar, scale, tp, style_);
  return frame;
}

}  // namespace pupflow::pictures
