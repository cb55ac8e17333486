#include "app/window/panels/histogram_panel.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/view/color_scale.h"
#include "app/window/panels/plot.h"

namespace pupflow::window {
namespace {

constexpr float kPaperLines = 5;

/// Reserves the room of a plot with its title and returns where its paper goes; nothing when it
/// cannot be seen.
std::optional<Area> place_plot(const PanelInput& in, const char* name, const std::string& title,
                               bool x_celsius = false) {
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x - plot_margin_left(), 10.0f);
  ImGui::Dummy({plot_margin_left() + width,
                (1.3f + kPaperLines) * em + plot_margin_below(in.fonts, x_celsius)});
  in.events.widget(name);
  if (!ImGui::IsItemVisible()) return std::nullopt;
  draw_rich_text(*ImGui::GetWindowDrawList(), in.fonts, corner, kInk, title);
  return Area{{corner.x + plot_margin_left(), corner.y + 1.3f * em}, {width, kPaperLines * em}};
}

double highest(const Histogram& bars) {
  return *std::max_element(bars.counts.begin(), bars.counts.end());
}

/// Bins as wide as a fifth of the distance of ticks, between round numbers.
Histogram tb_histogram(std::span<const double> tb, double tp, double ta) {
  constexpr int kTicks = 6, kBinsPerTick = 5;
  Range range{tp, tp};
  widen(range, ta);
  for (const double value : tb) widen(range, value);
  const double edge = 0.02 * (range.high - range.low);  // lines on the frame would not be seen
  range = rounded({range.low - edge, range.high + edge}, kTicks);
  const double spacing = view::tick_spacing(range.low, range.high, kTicks);
  const int bins = static_cast<int>((range.high - range.low) / spacing + 0.5) * kBinsPerTick;
  return histogram(tb, range, std::max(bins, 1));
}

void draw_tb(const PanelInput& in) {
  const auto paper = place_plot(in, "histogram-tb", "pups by T_b", true);
  if (!paper) return;
  const LitterView litter = in.state.view();
  const double tp = litter.params.preferred_temperature, ta = litter.params.ambient_temperature;
  const Histogram bars = tb_histogram(litter.tb, tp, ta);
  const PlotColors colors = plot_colors();
  const double top = std::max(1.15 * highest(bars), 2.0);
  const Plot plot(in.fonts, *paper,
                  {.x = bars.range, .y = {0, top}, .y_least = 1, .x_celsius = true});
  plot.bars(bars, colors.curve);
  plot.upright(tp, colors.tp, true);
  plot.upright(ta, colors.ta, true);
  // Beside their lines, away from each other.
  const double em = static_cast<double>(ImGui::GetFontSize() / paper->size.x) *
                    (bars.range.high - bars.range.low);
  const double side = tp >= ta ? 0.8 * em : -0.8 * em;
  plot.text(tp + side, top, colors.tp, "T\u209a");
  plot.text(ta - side, top, colors.ta, "T\u2090");
}

void draw_groups(const PanelInput& in) {
  const auto paper = place_plot(in, "histogram-groups", "groups by size (pups)");
  const LitterView litter = in.state.view();
  if (!paper || litter.pups == 0 || !litter.recorded.has(Part::pairs)) return;
  constexpr int kMost = 40;
  std::vector<double> sizes;
  for (const int size : group_sizes(group_labels(litter.pups, litter.touching))) {
    sizes.push_back(size);
  }
  const int largest = static_cast<int>(*std::max_element(sizes.begin(), sizes.end()));
  const int width = (largest + kMost - 1) / kMost;  // sizes of a bin
  const int bins = std::max((largest + width - 1) / width, 1);
  const Histogram bars = histogram(sizes, {0.5, 0.5 + width * bins}, bins);
  const double top = std::max(1.15 * highest(bars), 2.0);
  const Plot plot(in.fonts, *paper, {.x = bars.range, .y = {0, top}, .x_least = 1, .y_least = 1});
  plot.bars(bars, plot_colors().curve);
}

}  // namespace

void draw_histogram_panel(const PanelInput& in) {
  const bool open = ImGui::CollapsingHeader("histograms");
  in.events.widget("histograms");
  if (!open) return;
  draw_tb(in);
  draw_groups(in);
}

}  // namespace pupflow::window
