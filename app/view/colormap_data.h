// The colors of each map, low to high.
#pragma once

#include <array>

#include "app/view/rgb.h"

namespace pupflow::view {

extern const std::array<Rgb, kColormapSize> kViridis, kInferno, kCividis, kJet;

}  // namespace pupflow::view
