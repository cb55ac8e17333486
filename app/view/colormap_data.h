// The colours of each map, low to high.
#pragma once

#include <array>

#include "app/view/colormap.h"

namespace pupflow::view {

extern const std::array<Rgb, kColormapSize> kViridis, kInferno, kCividis, kJet;

}  // namespace pupflow::view
