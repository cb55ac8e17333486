// The observables over time, one plot below the other.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/window/panels/panel.h"
#include "app/window/panels/plot.h"

namespace pupflow::window {

/// Stretches of time that plots may show; infinite: the whole run.
struct PlotSpan {
  double seconds;  // model time
  const char* text;
};
std::span<const PlotSpan> plot_spans();

/// The stretch of a run from `begin` to `end` that is shown around `now`: so many seconds, the last
/// ones where the run ends now; those after `begin` while it is shorter.
Range shown_time(double begin, double end, double now, double seconds);

class PlotsPanel {
 public:
  /// Draws the plots into the current Dear ImGui window.
  void draw(const PanelInput& in);

 private:
  struct Frame;  // what all plots of one frame share

  void draw_choices(const PanelInput& in, const Frame& frame);
  void draw_menu(const PanelInput& in, const Frame& frame);
  void export_items(const PanelInput& in, const Frame& frame);
  void draw_plot(const PanelInput& in, const Frame& frame, std::size_t observable, bool last);
  void draw_curves(const Plot& plot, const Frame& frame, std::size_t observable, bool second) const;
  static void name_temperatures(const Plot& plot, const Frame& frame);
  void draw_note(const PanelInput& in, const Frame& frame) const;
  void follow_mouse(Frame& frame) const;
  double window_of(std::size_t observable) const;

  std::size_t span_ = 1, smoothing_ = 2;
  float top_ = 0, bottom_ = 0;  // of the plots, in the last frame
};

}  // namespace pupflow::window
