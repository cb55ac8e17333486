#include "app/window/panels/phase_panel.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/io/celsius.h"
#include "app/io/text.h"
#include "app/window/panels/figure2_curve.h"
#include "app/window/panels/plot.h"

namespace pupflow::window {
namespace {

constexpr float kPaperLines = 11;

struct TrailPoint {
  double ta, huddling, time;
};

/// Where the run has been, oldest first, up to the step that is shown.
std::vector<TrailPoint> trail_of(const LitterState& state) {
  const History& history = state.history;
  if (history.empty()) return {};
  const std::int64_t now = state.view().step;
  std::vector<TrailPoint> trail;
  for (const History::Entry& entry : history.between(history.first(), now)) {
    const History::Sample& sample = *entry.sample;
    if (sample.first <= now) trail.push_back({sample.ta, sample.mean.huddling, sample.time});
  }
  return trail;
}

/// Later stretches are darker. Points closer than a pixel are left out.
void draw_trail(const Plot& plot, const std::vector<TrailPoint>& trail, ImU32 color) {
  constexpr float kOldest = 0.2f, kThickness = 1.4f;
  std::vector<Column> piece;
  for (std::size_t i = 0; i < trail.size(); ++i) {
    const double y = trail[i].huddling;
    const Column here{plot.x().place(trail[i].ta), y, y, y, y};
    if (!piece.empty() && i + 1 < trail.size()) {
      const float dx = here.x - piece.back().x;
      const float dy = plot.y().place(y) - plot.y().place(piece.back().last);
      if (dx * dx + dy * dy < 1) continue;
    }
    piece.push_back(here);
    if (piece.size() < 2) continue;
    const float age = static_cast<float>(i) / static_cast<float>(trail.size());
    plot.curve(piece, faded(color, kOldest + (1 - kOldest) * age), kThickness);
    piece.erase(piece.begin());
  }
  if (!trail.empty()) plot.dot(trail.back().ta, trail.back().huddling, color);
}

std::vector<CurvePoint> reference() {
  std::vector<CurvePoint> curve;
  for (const HuddlingPoint& p : figure2_curve()) {
    curve.push_back({p.ta, p.huddling, p.huddling - p.deviation, p.huddling + p.deviation});
  }
  return curve;
}

/// The reference as a band and, without its extremes, as a line.
void draw_reference(const Plot& plot, const PlotColors& colors) {
  std::vector<Column> curve = columns(reference(), plot.x());
  plot.band(curve, colors.grid);
  for (Column& column : curve) column.low = column.high = column.last;
  plot.curve(curve, colors.reference);
}

/// The point of the trail under the mouse, in words.
std::string pointed_text(const Plot& plot, const Area& paper,
                         const std::vector<TrailPoint>& trail) {
  const ImVec2 mouse = ImGui::GetMousePos();
  const float reach = ImGui::GetFontSize();
  const TrailPoint* nearest = nullptr;
  float least = reach * reach;
  if (!paper.holds(mouse) || !ImGui::IsWindowHovered()) return {};
  for (const TrailPoint& point : trail) {
    const float dx = plot.x().place(point.ta) - mouse.x;
    const float dy = plot.y().place(point.huddling) - mouse.y;
    if (dx * dx + dy * dy > least) continue;
    least = dx * dx + dy * dy;
    nearest = &point;
  }
  if (!nearest) return {};
  plot.dot(nearest->ta, nearest->huddling, plot_colors().now);
  return io::formatted("at %.2f s: T_a ", nearest->time) +
         io::with_celsius(io::formatted("%.3g", nearest->ta), nearest->ta, true) +
         io::formatted(", 1 − A %.3f", nearest->huddling);
}

}  // namespace

void draw_phase_panel(const PanelInput& in) {
  const bool open = ImGui::CollapsingHeader("huddling against T\u2090");
  in.events.widget("phase");
  if (!open) return;
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x - plot_margin_left(), 10.0f);
  const Area paper{{corner.x + plot_margin_left(), corner.y + 1.3f * em},
                   {width, kPaperLines * em}};
  const float below = plot_margin_below(in.fonts, true);
  ImGui::Dummy({plot_margin_left() + width, (1.3f + kPaperLines) * em + below});
  in.events.widget("phase-plot");
  if (!ImGui::IsItemVisible()) return;

  draw_rich_text(*ImGui::GetWindowDrawList(), in.fonts, corner, kInk, "huddling 1 − A");
  const std::vector<TrailPoint> trail = trail_of(in.state);
  const std::vector<TrailPoint> second =
      in.state.second ? trail_of(*in.state.second) : std::vector<TrailPoint>{};
  Range x{0, 1}, y{0, 0.7};
  for (const auto* path : {&trail, &second}) {
    for (const TrailPoint& point : *path) {
      widen(x, point.ta);
      widen(y, point.huddling);
    }
  }
  const PlotColors colors = plot_colors();
  std::string note;
  {
    const Plot plot(in.fonts, paper, {.x = x, .y = y, .x_celsius = true});
    draw_reference(plot, colors);
    draw_trail(plot, second, colors.second);
    draw_trail(plot, trail, colors.curve);
    note = pointed_text(plot, paper, trail);
  }
  if (note.empty()) note = "T_a; grey: Figure 2, its mean and deviation";
  in.events.note("phase", note);
  small_rich_text(in.fonts, kFaint, note);
}

}  // namespace pupflow::window
