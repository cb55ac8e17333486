// How large the window's pictures and films are.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace pupflow::window {

struct PixelSize {
  int width = 0, height = 0;
  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// So many times as large as the arena with its legend is seen, or `pixels` where these are given.
struct PictureSize {
  int times = 1;
  PixelSize pixels = {};

  /// In pixels. Keeps within what pictures may have.
  PixelSize of(PixelSize seen) const;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// The sizes that a menu offers.
struct OfferedSize {
  std::string_view name;  // one word
  std::string_view text;
  PictureSize size;
};
std::span<const OfferedSize> offered_sizes();

/// "1920x1080", with blanks or the sign of multiplication as well; or why that is no size.
std::variant<PixelSize, std::string> read_size(std::string_view text);

/// "1920 × 1080"
std::string size_text(PixelSize size);

}  // namespace pupflow::window
