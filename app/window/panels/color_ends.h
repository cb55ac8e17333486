// The ends of a color scale, worked by hand.
#pragma once

#include <string>
#include <string_view>

#include "app/view/color_scale.h"

namespace pupflow::window {

enum class ScaleEnd { low, high };

/// `value` as it is shown at an end of a bar from `low` to `high`: as fine as a hundredth of the bar.
std::string end_text(double value, double low, double high);

/// An end of a bar, held by the mouse. The bar stays where it is: by how far the mouse goes up, so
/// far the value goes up the scale that there was at first.
struct EndDrag {
  ScaleEnd end;
  double low, high;  // of the scale when the end was taken
  double length;     // of the bar, pixels
  double from;       // where the mouse took it, pixels downwards

  /// The end's value with the mouse at `y`: a number as round as a pixel allows, on its own side of
  /// the other end.
  double value_at(double y) const;
};

/// `scale` with that end at `value`, and the other one where the fitted scale shows it. Throws Failure
/// where no scale could have it so; its text names the other end.
view::ColorScale with_end(const view::ColorScale& scale, const view::ColorScale& fitted,
                          ScaleEnd end, double value);

/// Takes the ends of `scale` from somewhere else. Leaving Ends::around_tp gives back the color map
/// that it brought along.
void choose_ends(view::ColorScale& scale, view::Ends ends);

/// What the ends of a scale are called in a list: "auto", "0 to 1", "around T_p", "typed".
std::string ends_label(const view::ColorScale& scale, view::Ends ends);

/// Whether that choice makes sense for the scale: none does for categories and angles.
bool ends_apply(const view::ColorScale& scale, view::Ends ends);

}  // namespace pupflow::window
