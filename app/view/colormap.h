// Colour maps, and the scale that turns a body temperature into a colour.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pupflow::view {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

constexpr int kColormapSize = 256;

/// A colour map: sRGB colours from low to high.
using Colormap = std::span<const Rgb, kColormapSize>;

/// The maps by name: viridis, inferno, cividis (perceptually even, safe for colour-blind eyes),
/// jet.
std::span<const std::string_view> colormap_names();

/// The map called `name`; lives as long as the program. Throws Failure(bad_input) for any other.
Colormap find_colormap(std::string_view name);

/// Colours for the values from min to max; what lies outside takes the colour of the nearer end.
struct ColorScale {
  Colormap map;
  double min = 0, max = 1;

  /// Throws Failure(bad_input) for an unknown map or unless `low` < `high`, both finite.
  ColorScale(std::string_view map_name, double low, double high);

  /// The colour of `value`; NaN takes the low end's.
  Rgb operator()(double value) const;
};

}  // namespace pupflow::view
