// A plot: paper with axes, and what is drawn on it.
#pragma once

#include <imgui.h>

#include <span>
#include <string>

#include "app/window/panel_text.h"
#include "app/window/panels/area.h"
#include "app/window/panels/plot_geometry.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// Colors of curves. Those that are opaque can be read as text, too, on papers and panels.
struct PlotColors {
  ImU32 curve, band, raw;  // of the litter; all its pups; before smoothing
  ImU32 second;            // of the litter that is compared
  ImU32 selected;          // of the selected pup
  ImU32 tp, ta;
  ImU32 reference;  // what other runs gave
  ImU32 grid, zero, now, mark;
};
PlotColors plot_colors(const Palette& of = palette());

/// How wide the labels left of a plot's paper are, and how high those below it.
float plot_margin_left();
float plot_margin_below(const Fonts& fonts, bool x_celsius = false);

/// What the axes of a plot look like.
struct PlotAxes {
  Range x, y;
  bool x_labels = true;             // whether the x axis has labels
  double x_least = 0, y_least = 0;  // ticks are not closer; 1 for whole numbers
  bool x_celsius = false;           // x is a temperature: degrees stand below its labels
};

/// Draws paper, grid and labels into the current Dear ImGui window when made. Whatever is drawn
/// afterwards is clipped to the paper, until it is destroyed.
class Plot {
 public:
  Plot(const Fonts& fonts, const Area& paper, const PlotAxes& axes);
  ~Plot();
  Plot(const Plot&) = delete;
  Plot& operator=(const Plot&) = delete;

  const Axis& x() const { return x_; }
  const Axis& y() const { return y_; }

  /// A line through the means; a vertical one where a column has extremes.
  void curve(std::span<const Column> curve, ImU32 color, float thickness = 1) const;
  /// The area between the extremes.
  void band(std::span<const Column> curve, ImU32 color) const;
  void bars(const Histogram& bars, ImU32 color) const;
  /// Dashed lines across the paper, and a stretch of it.
  void across(double y, ImU32 color) const;
  void upright(double x, ImU32 color, bool dashed = false) const;
  void stretch(double low, double high, ImU32 color) const;
  void dot(double x, double y, ImU32 color) const;
  /// Small text on the paper with its middle at (x, y), moved to where the paper has room.
  void text(double x, double y, ImU32 color, const std::string& text, float lift = 0) const;

 private:
  void draw_axes(const PlotAxes& axes) const;
  void draw_celsius() const;

  const Fonts& fonts_;
  ImDrawList& list_;
  Area paper_;
  Axis x_, y_;
};

}  // namespace pupflow::window
