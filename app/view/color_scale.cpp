#include "app/view/color_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::view {

namespace {

constexpr int kTicks = 5;
constexpr double kLeastWidth = 0.02;  // of a scale from the data, of the field's drawn range
constexpr double kFurthestEnd =
    std::numeric_limits<double>::max() / 2;  // their difference is finite

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

/// The value below which a share of `known` lies; reorders it.
double quantile(std::vector<double>& known, double share) {
  const auto place =
      static_cast<std::ptrdiff_t>(share * static_cast<double>(known.size() - 1) + 0.5);
  std::ranges::nth_element(known, known.begin() + place);
  return known[static_cast<std::size_t>(place)];
}

/// Sets both ends of `scale` from the middle of `known`.
void take_middle(ColorScale& scale, std::vector<double>& known, double tp) {
  double low = 0, high = 1;
  if (!known.empty()) low = quantile(known, 0.05), high = quantile(known, 0.95);
  // Differences that no reader could use are not spread over all colors.
  const double drawn = scale.field->high - scale.field->low;
  const double least = kLeastWidth * (drawn > 0 ? drawn : std::max(std::abs(low), std::abs(high)));
  const double lacking = std::max(std::max(least, 1e-9) - (high - low), 0.0);
  low -= lacking / 2;
  high += lacking / 2;
  const bool around = scale.ends == Ends::around_tp;
  if (around || scale.field->kind == FieldKind::signed_) {
    const double centre = around ? tp : scale.field->centre;
    const double reach = std::max(high - centre, centre - low);
    low = centre - reach;
    high = centre + reach;
  }
  scale.min = low;
  scale.max = high;
}

/// The ends of a scale, where they are round numbers.
void round_outwards(ColorScale& scale, bool low_end, bool high_end, double least) {
  const double spacing = tick_spacing(scale.min, scale.max, kTicks, least);
  if (low_end) scale.min = spacing * std::floor(scale.min / spacing + 1e-9);
  if (high_end) scale.max = spacing * std::ceil(scale.max / spacing - 1e-9);
}

/// Sets the open ends of `scale` to those of the values, rounded outwards.
void take_all(ColorScale& scale, double low, double high) {
  const bool low_end = std::isnan(scale.min), high_end = std::isnan(scale.max);
  if (!low_end && !high_end) return;
  if (!(low <= high)) low = 0, high = 1;  // nothing is known
  if (scale.field->kind == FieldKind::signed_) {
    const double reach = std::max(high - scale.field->centre, scale.field->centre - low);
    low = scale.field->centre - reach;
    high = scale.field->centre + reach;
  }
  if (low_end) scale.min = high_end ? low : std::min(low, scale.max);
  if (high_end) scale.max = std::max(high, scale.min);
  if (scale.categorical()) return;
  const double width = scale.max - scale.min;
  if (width <= 1e-9 * std::max(1.0, std::abs(scale.max))) {  // one value
    (high_end ? scale.max : scale.min) += high_end ? 1 : -1;
  }
  round_outwards(scale, low_end, high_end, scale.field->digits == 0 ? 1 : 0);
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
  if (!std::isfinite(high - low)) {
    fail("the ends of the color scale are too far apart; they must differ by at most 1.7e308");
  }
  min = low;
  max = high;
  // So that such a bar has one width, however its ends were named.
  ends = low == field->low && high == field->high ? Ends::field : Ends::typed;
}

void ColorScale::set_ends(Ends from) {
  const std::string name(field->name);
  if (categorical()) fail(name + " is categorical: it has no scale");
  if (field->kind == FieldKind::angle) fail(name + " is an angle: its scale is always -pi to pi");
  if (from == Ends::around_tp) {
    if (!is_temperature()) fail(name + " is no temperature: T_p has no place on its scale");
    if (map_name == usual_map(field->kind)) set_map("bluered");
  }
  ends = from;
  const bool open = from == Ends::automatic || from == Ends::around_tp;
  min = open ? kFromData : field->low;
  max = open ? kFromData : field->high;
}

ColorScale ColorScale::fitted(std::span<const double> values, double tp) const {
  ColorScale scale = *this;
  std::vector<double> known;
  for (const double value : values) {
    scale.unknown = scale.unknown || std::isnan(value);
    if (std::isfinite(value)) known.push_back(value);
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : known) low = std::min(low, value), high = std::max(high, value);
  if (std::isnan(min) && (ends == Ends::automatic || ends == Ends::around_tp)) {
    take_middle(scale, known, tp);
  } else {
    take_all(scale, low, high);
  }
  if (!(scale.max - scale.min <= std::numeric_limits<double>::max())) {
    scale.min =
        std::isnan(scale.min) ? -kFurthestEnd : std::clamp(scale.min, -kFurthestEnd, kFurthestEnd);
    scale.max =
        std::isnan(scale.max) ? kFurthestEnd : std::clamp(scale.max, -kFurthestEnd, kFurthestEnd);
  }
  scale.below = low < scale.min;
  scale.above = high > scale.max && !known.empty();
  return scale;
}

void ColorScale::follow_data() {
  if (!categorical() && field->kind != FieldKind::angle) set_ends(Ends::automatic);
}

bool ColorScale::follows(const ColorScale& before) const {
  return ends != Ends::field && ends != Ends::typed && ends == before.ends &&
         field->name == before.field->name && map_name == before.map_name;
}

ColorScale ColorScale::eased(const ColorScale& before, double share) const {
  ColorScale scale = *this;
  scale.min = before.min + share * (min - before.min);
  scale.max = before.max + share * (max - before.max);
  return scale;
}

Rgb ColorScale::operator()(double value) const {
  if (std::isnan(value)) return kUnknownColor;
  if (categorical()) {
    if (value < 0) return kNobodyColor;
    return map[static_cast<std::size_t>(std::fmod(value, kCategoryColors))];
  }
  // Halves of the ends, whose differences are finite.
  double low = min / 2, high = max / 2;
  if (field->kind == FieldKind::signed_) {
    const double centre = field->centre / 2, reach = std::max(high - centre, centre - low);
    low = centre - reach;
    high = centre + reach;
  }
  const double share = (value / 2 - low) / (high - low);
  if (!(share > 0)) return map.front();
  const double index = std::min(share, 1.0) * kColormapSize;
  return map[static_cast<std::size_t>(std::min(index, kColormapSize - 1.0))];
}

bool ColorScale::same_as(const ColorScale& other) const {
  return field->name == other.field->name && map_name == other.map_name && min == other.min &&
         max == other.max && unknown == other.unknown && below == other.below &&
         above == other.above;
}

double easing(double seconds) {
  constexpr double kHalfSecond = 0.5;
  return 1 - std::exp(-seconds / kHalfSecond);
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
  constexpr double kWhole = 0x1p53;  // all whole numbers up to it are a double
  const double step = tick_spacing(low, high, count, least);
  std::vector<double> ticks;
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  if (!(first > -kWhole && last < kWhole)) return ticks;  // nor where one is no number
  for (double i = first + 0.0; i <= last; ++i) ticks.push_back(i * step);  // 0 where that is -0
  return ticks;
}

}  // namespace pupflow::view
