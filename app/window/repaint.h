// Which pixels of the window a new frame changes.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <span>
#include <vector>

namespace pupflow::window {

/// Pixels of the framebuffer, from its upper left corner; `right` and `bottom` are outside.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool empty() const { return right <= left || bottom <= top; }
  bool holds(const PixelBox& other) const {
    return other.left >= left && other.top >= top && other.right <= right && other.bottom <= bottom;
  }
  bool operator==(const PixelBox&) const = default;
};

/// The pixels of both.
PixelBox common(const PixelBox& a, const PixelBox& b);

/// Compares what Dear ImGui wants drawn with what it wanted last time, tile by tile. A texture of the
/// same name counts as unchanged.
class Repaint {
 public:
  static constexpr int kTile = 32;  // edge, pixels

  /// The boxes, apart from each other, in which the window changes: where `data` differs from that of
  /// the last call, and on `images` (places that hold pictures, drawn below) when `new_images`. No
  /// box has tiles that lie in an image beside others. After `forget`, or at another size, they cover
  /// the window.
  std::vector<PixelBox> changed(const ImDrawData& data, std::span<const PixelBox> images,
                                bool new_images);

  /// The window's pixels are lost.
  void forget() { tiles_.clear(); }

 private:
  int columns_ = 0, rows_ = 0;
  PixelBox window_;
  std::vector<PixelBox> images_;
  std::vector<std::uint64_t> tiles_;  // hashes of what is drawn there
};

/// At most `most` boxes that cover these, and little else.
std::vector<PixelBox> gathered(std::span<const PixelBox> boxes, std::size_t most);

/// Leaves in `data` what touches `boxes`, cut to them.
void cut_to(ImDrawData& data, std::span<const PixelBox> boxes);

}  // namespace pupflow::window
