// Curves of a history's samples.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/window/panels/plot_geometry.h"
#include "app/window/session/history.h"

namespace pupflow::window {

using Entries = std::span<const History::Entry>;

/// An observable over time; with a window of seconds, its mean over that time up to each point.
std::vector<CurvePoint> observable_curve(Entries entries, std::size_t observable, double window);

/// T_b of all pups: the coldest and the warmest.
std::vector<CurvePoint> tb_band(Entries entries);

/// T_b of one pup, where it is kept.
std::vector<CurvePoint> pup_curve(Entries entries, int pup);

/// T_a or T_p.
std::vector<CurvePoint> temperature_curve(Entries entries, double History::Sample::*temperature);

/// Widens `range` to what is drawn of an observable within `time`: all there is, of a smoothed one
/// the smooth curve.
void widen_to(Range& range, Entries entries, std::size_t observable, Range time, double window);

/// The mean at the point that `x` belongs to: the first that does not lie before it. Nothing
/// outside the curve.
std::optional<double> value_at(std::span<const CurvePoint> curve, double x);

}  // namespace pupflow::window
