#include "app/view/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "app/view/colormap_data.h"

namespace pupflow::view {

namespace {

using Colors = std::array<Rgb, kColormapSize>;

constexpr std::array<std::string_view, 6> kNames{"viridis", "inferno", "cividis",
                                                 "jet",     "bluered", "phase"};

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// ColorBrewer's RdBu from blue to red, by linear interpolation.
Colors make_bluered() {
  constexpr std::array<Rgb, 11> kKnots{{{5, 48, 97},
                                        {33, 102, 172},
                                        {67, 147, 195},
                                        {146, 197, 222},
                                        {209, 229, 240},
                                        {247, 247, 247},
                                        {253, 219, 199},
                                        {244, 165, 130},
                                        {214, 96, 77},
                                        {178, 24, 43},
                                        {103, 0, 31}}};
  Colors colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double place = static_cast<double>(i * (kKnots.size() - 1)) / (kColormapSize - 1);
    const std::size_t knot = std::min(static_cast<std::size_t>(place), kKnots.size() - 2);
    const double share = place - static_cast<double>(knot);
    const Rgb a = kKnots[knot], b = kKnots[knot + 1];
    const auto mix = [&](int low, int high) { return byte(low + share * (high - low)); };
    colors[i] = {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
  }
  return colors;
}

/// All hues round at one chroma in Oklab (Ottosson 2020). 0, in the middle of the map, is the hue
/// of red. Green is lighter than purple, so that eyes that lack a kind of cone see two
/// dimensions, too.
Colors make_phase() {
  constexpr double kLightness = 0.66, kSwing = 0.2, kLightHue = 2.7, kChroma = 0.11, kRedHue = 0.51;
  const auto encoded = [](double c) {
    c = std::clamp(c, 0.0, 1.0);
    return byte(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055));
  };
  Colors colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double turn = (static_cast<double>(i) + 0.5) / kColormapSize - 0.5;
    const double hue = kRedHue + 2 * std::numbers::pi * turn;
    const double lightness = kLightness + kSwing * std::cos(hue - kLightHue);
    const double a = kChroma * std::cos(hue), b = kChroma * std::sin(hue);
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    colors[i] = {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                 encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                 encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
  }
  return colors;
}

/// Found by simulated annealing: at least 24 CIE Lab units apart, and from floor and greys, for
/// usual eyes and those that lack a kind of cone (Machado et al. 2009). The first ones differ most.
Colors make_categories() {
  constexpr std::array<Rgb, kCategoryColors> kDistinct{{{20, 63, 182},
                                                        {220, 123, 27},
                                                        {103, 240, 169},
                                                        {161, 122, 171},
                                                        {151, 14, 44},
                                                        {112, 48, 126},
                                                        {109, 130, 255},
                                                        {255, 156, 255},
                                                        {162, 234, 121},
                                                        {113, 152, 110},
                                                        {239, 216, 63},
                                                        {149, 80, 0}}};
  Colors colors;
  for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = kDistinct[i % kDistinct.size()];
  return colors;
}

}  // namespace

std::span<const std::string_view> colormap_names() {
  return kNames;
}

Colormap find_colormap(std::string_view name) {
  static const Colors bluered = make_bluered(), phase = make_phase();
  const std::array<Colormap, kNames.size()> maps{kViridis, kInferno, kCividis,
                                                 kJet,     bluered,  phase};
  const auto found = std::ranges::find(kNames, name);
  if (found != kNames.end()) return maps[static_cast<std::size_t>(found - kNames.begin())];
  std::string hint = io::did_you_mean(name, kNames);
  if (hint.empty()) {
    for (const std::string_view known : kNames) {
      hint += (hint.empty() ? "; there are " : ", ") + std::string(known);
    }
  }
  throw io::Failure(io::ExitCode::bad_input, "unknown color map " + io::quoted(name) + hint);
}

Colormap category_colors() {
  static const Colors categories = make_categories();
  return categories;
}

}  // namespace pupflow::view
