// Color maps: colors from the low end of a scale to its high end.
#pragma once

#include <span>
#include <string_view>

#include "app/view/rgb.h"

namespace pupflow::view {

/// A color map: sRGB colors from low to high.
using Colormap = std::span<const Rgb, kColormapSize>;

/// The maps by name. From low to high: viridis, inferno, cividis (perceptually even, safe for
/// color-blind eyes) and jet. To both sides of a middle: bluered. With equal ends: phase.
std::span<const std::string_view> colormap_names();

/// The map called `name`; lives as long as the program. Throws Failure(bad_input) for any other.
Colormap find_colormap(std::string_view name);

/// How many colors tell categories apart; then they repeat.
constexpr int kCategoryColors = 12;

/// The colors of the categories 0, 1, ..., repeated up to kColormapSize.
Colormap category_colors();

}  // namespace pupflow::view
