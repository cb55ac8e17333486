// A color, and how many of them make a color map.
#pragma once

#include <cstdint>

namespace pupflow::view {

/// sRGB, a byte a component.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

constexpr int kColormapSize = 256;

}  // namespace pupflow::view
