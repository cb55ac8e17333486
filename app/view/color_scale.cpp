#include "app/view/color_scale.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::view {

namespace {

constexpr int kTicks = 5;

[[noreturn]] void fail(const std::string& what) {
  throw io::Failure(io::ExitCode::bad_input, what);
}

std::string_view usual_map(FieldKind kind) {
  switch (kind) {
    case FieldKind::continuous:
      return "viridis";
    case FieldKind::signed_:
      return "bluered";
    case FieldKind::angle:
      return "phase";
    case FieldKind::categorical:
      return "";
  }
  return "viridis";
}

/// The ends of a scale, where they are round numbers.
void round_outwards(ColorScale& scale, bool low_end, bool high_end, double least) {
  const double spacing = tick_spacing(scale.min, scale.max, kTicks, least);
  if (low_end) scale.min = spacing * std::floor(scale.min / spacing + 1e-9);
  if (high_end) scale.max = spacing * std::ceil(scale.max / spacing - 1e-9);
}

}  // namespace

ColorScale::ColorScale(const LitterField& shown)
    : field(&shown),
      map_name(usual_map(shown.kind)),
      map(categorical() ? category_colors() : find_colormap(map_name)),
      min(shown.low),
      max(shown.high) {}

ColorScale::ColorScale(std::string_view name, double low, double high, const LitterField& shown)
    : ColorScale(shown) {
  set_map(name);
  set_range(low, high);
}

void ColorScale::set_map(std::string_view name) {
  if (categorical()) {
    fail(std::string(field->name) + " is categorical: its colors are fixed, without a color map");
  }
  map = find_colormap(name);
  map_name = *std::ranges::find(colormap_names(), name);  // lives as long as the program
}

void ColorScale::set_range(double low, double high) {
  if (categorical()) fail(std::string(field->name) + " is categorical: it has no scale");
  if (field->kind == FieldKind::angle) {
    fail(std::string(field->name) + " is an angle: its scale is always -pi to pi");
  }
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) {
    fail("the color scale must go from a lower to a higher finite value, not from " +
         io::number_text(low) + " to " + io::number_text(high));
  }
  min = low;
  max = high;
}

ColorScale ColorScale::fitted(std::span<const double> values) const {
  ColorScale scale = *this;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (std::isnan(value)) {
      scale.unknown = true;
    } else if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  const bool low_end = std::isnan(min), high_end = std::isnan(max);
  if (!low_end && !high_end) return scale;
  if (!(low <= high)) low = 0, high = 1;  // nothing is known
  if (field->kind == FieldKind::signed_) {
    const double reach = std::max(high - field->centre, field->centre - low);
    low = field->centre - reach;
    high = field->centre + reach;
  }
  if (low_end) scale.min = high_end ? low : std::min(low, max);
  if (high_end) scale.max = std::max(high, scale.min);
  if (categorical()) return scale;
  const double least = field->digits == 0 ? 1 : 0;
  const double width = scale.max - scale.min;
  if (width <= 1e-9 * std::max(1.0, std::abs(scale.max))) {  // one value
    (high_end ? scale.max : scale.min) += high_end ? 1 : -1;
  }
  round_outwards(scale, low_end, high_end, least);
  return scale;
}

Rgb ColorScale::operator()(double value) const {
  if (std::isnan(value)) return kUnknownColor;
  if (categorical()) {
    if (value < 0) return kNobodyColor;
    return map[static_cast<std::size_t>(std::fmod(value, kCategoryColors))];
  }
  double low = min, high = max;
  if (field->kind == FieldKind::signed_) {
    const double reach = std::max(max - field->centre, field->centre - min);
    low = field->centre - reach;
    high = field->centre + reach;
  }
  const double share = (value - low) / (high - low);
  if (!(share > 0)) return map.front();
  const double index = std::min(share, 1.0) * kColormapSize;
  return map[static_cast<std::size_t>(std::min(index, kColormapSize - 1.0))];
}

bool ColorScale::same_as(const ColorScale& other) const {
  return field->name == other.field->name && map_name == other.map_name && min == other.min &&
         max == other.max && unknown == other.unknown;
}

double tick_spacing(double low, double high, int count, double least) {
  const double rough = std::max((high - low) / count, least);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= 0.999 * rough) step = factor * power;
  }
  return step;
}

std::vector<double> round_ticks(double low, double high, int count, double least) {
  const double step = tick_spacing(low, high, count, least);
  std::vector<double> ticks;
  const auto first = std::llround(std::ceil(low / step - 1e-9));
  const auto last = std::llround(std::floor(high / step + 1e-9));
  for (auto i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

}  // namespace pupflow::view
