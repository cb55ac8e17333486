// The scale that turns the values of a field into colors.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "app/io/celsius.h"
#include "app/view/colormap.h"
#include "pupflow/fields.h"

namespace pupflow::view {

/// The color of values that are not known (NaN), and of category -1 (nobody, none).
constexpr Rgb kUnknownColor{184, 186, 189}, kNobodyColor{92, 96, 102};

/// Where the ends of a scale come from.
enum class Ends {
  field,      // the field's drawn range; the data where it has none
  typed,      // set_range
  automatic,  // the middle 90 % of the values: 5 to 95 %
  around_tp   // as far from T_p, to both sides, as the automatic ends are
};

/// As they are typed; numbers are, for Ends::typed.
constexpr std::array<std::string_view, 4> kEndsNames{"field", "", "auto", "around-tp"};

inline std::string_view name_of(Ends ends) {
  return kEndsNames[static_cast<std::size_t>(ends)];
}

/// Which field is shown, and the color of each of its values. A plain value.
///
/// continuous: the color map from min to max; what lies outside takes the color of the nearer end.
/// signed: the middle of the map is the field's centre, and both sides of it are as long as the
/// longer one. angle: the map from min to max, which have the same color. categorical: category i
/// takes color i of category_colors().
struct ColorScale {
  /// Of the table of the binary that made the scale. The graphics module has a table of its own:
  /// compare names, not addresses.
  const LitterField* field;
  std::string_view map_name;  // empty for categories
  Colormap map;
  double min, max;  // kFromData where the data decides (see fitted)
  Ends ends = Ends::field;

  // Of the values that it was fitted to:
  bool unknown = false;               // some are NaN
  bool below = false, above = false;  // some lie beyond an end

  /// The field's drawn range and the color map of its kind: viridis, bluered, phase.
  explicit ColorScale(const LitterField& shown);

  /// Of body temperature.
  ColorScale() : ColorScale(pup_fields().front()) {}

  /// The map called `name` from `low` to `high`. Throws as set_map and set_range do.
  ColorScale(std::string_view name, double low, double high,
             const LitterField& shown = pup_fields().front());

  /// Throws Failure(bad_input) for an unknown map and for a categorical field.
  void set_map(std::string_view name);

  /// Throws Failure(bad_input) unless low < high, both finite, and for a categorical field or an
  /// angle.
  void set_range(double low, double high);

  /// Takes both ends from the data, as `from` says. Throws Failure(bad_input) for a categorical
  /// field and an angle; for Ends::around_tp, which makes the map bluered unless another one was
  /// set, also unless the field is a temperature.
  void set_ends(Ends from);

  bool is_temperature() const { return io::is_temperature(*field); }

  /// The same for Ends::automatic, but leaves categories and angles as they are.
  void follow_data();

  bool categorical() const { return field->kind == FieldKind::categorical; }

  /// Whether both ends are known.
  bool is_fitted() const { return min <= max; }

  /// This scale with the ends that the data decides taken from `values`: for Ends::field rounded
  /// outwards to round numbers. 0 ... 1 where no value is known. `tp` is the preferred temperature.
  ColorScale fitted(std::span<const double> values, double tp = 0) const;

  /// Whether both are of the same field and map and take their ends from the data.
  bool follows(const ColorScale& before) const;

  /// A fitted scale that has gone `share` of the way from the ends of `before` to its own; for
  /// sequences, so that colors do not flicker.
  ColorScale eased(const ColorScale& before, double share) const;

  /// The color of `value`. Needs a fitted scale.
  Rgb operator()(double value) const;

  /// Whether the same values get the same colors and the same legend.
  bool same_as(const ColorScale& other) const;
};

/// The share of the way that an automatic scale goes to its new ends in so many model seconds.
double easing(double seconds);

/// Where the ticks of a scale stand. Round values within [low, high], about `count` of them, evenly
/// spaced by 1, 2 or 5 times a power of ten; not closer than `least`.
double tick_spacing(double low, double high, int count, double least = 0);
std::vector<double> round_ticks(double low, double high, int count, double least = 0);

}  // namespace pupflow::view
