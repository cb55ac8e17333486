#include "app/view/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/io/failure.h"
#include "app/view/colormap_data.h"

namespace pupflow::view {

namespace {

constexpr std::array<std::string_view, 4> kNames{"viridis", "inferno", "cividis", "jet"};

}  // namespace

std::span<const std::string_view> colormap_names() {
  return kNames;
}

Colormap find_colormap(std::string_view name) {
  const std::array<Colormap, kNames.size()> maps{kViridis, kInferno, kCividis, kJet};
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) {
    throw io::Failure(io::ExitCode::bad_input,
                      "no colour map is called '" + std::string(name) +
                          "'; there are viridis, inferno, cividis and jet");
  }
  return maps[static_cast<std::size_t>(found - kNames.begin())];
}

ColorScale::ColorScale(std::string_view map_name, double low, double high)
    : map(find_colormap(map_name)), min(low), max(high) {
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) {
    throw io::Failure(io::ExitCode::bad_input,
                      "the colour scale must go from a lower to a higher finite temperature, not "
                      "from " +
                          std::to_string(low) + " to " + std::to_string(high));
  }
}

Rgb ColorScale::operator()(double value) const {
  const double share = (value - min) / (max - min);
  if (!(share > 0)) return map.front();
  const double index = std::min(share, 1.0) * kColormapSize;
  return map[static_cast<std::size_t>(std::min(index, kColormapSize - 1.0))];
}

}  // namespace pupflow::view
