#include "app/window/panels/color_ends.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/view/color_bar.h"

namespace pupflow::window {
namespace {

/// Digits after the point of the power of ten that is not above `step`.
int digits_for(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 300);
}

/// `value` rounded to the power of ten that is not above `step`.
double rounded(double value, double step) {
  if (step >= 1) {
    const double unit = std::pow(10, std::floor(std::log10(step) + 1e-9));
    return std::round(value / unit) * unit;
  }
  return std::strtod(io::formatted("%.*f", digits_for(step), value).c_str(), nullptr);
}

}  // namespace

std::string end_text(double value, double low, double high) {
  const double step = (high - low) / 100;
  return io::number_text(step > 0 ? rounded(value, step) : value);
}

double EndDrag::value_at(double y) const {
  const double pixel = (high - low) / length, least = std::max((high - low) / 100, pixel);
  const double moved = (from - y) * pixel;
  if (end == ScaleEnd::high) return std::max(rounded(high + moved, pixel), low + least);
  return std::min(rounded(low + moved, pixel), high - least);
}

view::ColorScale with_end(const view::ColorScale& scale, const view::ColorScale& fitted,
                          ScaleEnd end, double value) {
  const auto shown = [&](double other) {
    if (fitted.ends == view::Ends::typed) return other;
    return *io::read_number<double>(end_text(other, fitted.min, fitted.max));
  };
  const double low = end == ScaleEnd::low ? value : shown(fitted.min);
  const double high = end == ScaleEnd::high ? value : shown(fitted.max);
  if (!(low < high)) {
    io::refuse(end == ScaleEnd::high ? "the upper end must be above " + io::number_text(low)
                                     : "the lower end must be below " + io::number_text(high));
  }
  view::ColorScale changed = scale;
  changed.set_range(low, high);
  return changed;
}

void choose_ends(view::ColorScale& scale, view::Ends ends) {
  const view::ColorScale usual(*scale.field);
  const bool brought = scale.ends == view::Ends::around_tp && scale.map_name == "bluered";
  if (brought && ends != view::Ends::around_tp) scale.set_map(usual.map_name);
  scale.set_ends(ends);
}

std::string ends_label(const view::ColorScale& scale, view::Ends ends) {
  const Field& field = *scale.field;
  switch (ends) {
    case view::Ends::automatic:
      return "auto";
    case view::Ends::around_tp:
      return "around T_p";
    case view::Ends::typed:
      return "typed";
    case view::Ends::field:
      break;
  }
  if (std::isnan(field.low) || std::isnan(field.high)) return "all values";
  return view::tick_label(field.low) + " to " + view::tick_label(field.high);
}

bool ends_apply(const view::ColorScale& scale, view::Ends ends) {
  if (scale.categorical() || scale.field->kind == FieldKind::angle) return false;
  return ends != view::Ends::around_tp || scale.is_temperature();
}

}  // namespace pupflow::window
