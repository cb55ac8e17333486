#include "app/window/panels/plot.h"

#include <algorithm>
#include <cmath>

#include "app/io/celsius.h"

namespace pupflow::window {
namespace {

float line_width() {
  return 0.1f * ImGui::GetFontSize();
}

/// The papers of plots are those of lists and tooltips.
ImU32 paper_color() {
  return palette().popup;
}

}  // namespace

PlotColors plot_colors(const Palette& of) {
  return {.curve = of.accent,
          .band = faded(of.accent, 0.22f),
          .raw = faded(of.accent, 0.4f),
          .second = of.second,
          .selected = of.selected,
          .tp = of.tp,
          .ta = of.ta,
          .reference = of.reference,
          .grid = faded(of.ink, 0.08f),
          .zero = faded(of.ink, 0.35f),
          .now = faded(of.ink, 0.75f),
          .mark = faded(of.ink, 0.35f)};
}

float plot_margin_left() {
  return 2.9f * ImGui::GetFontSize();
}

float plot_margin_below(const Fonts& fonts, bool x_celsius) {
  return (x_celsius ? 2 : 1) * small_text_size(fonts, "0").y + 0.3f * ImGui::GetFontSize();
}

Plot::Plot(const Fonts& fonts, const Area& paper, const PlotAxes& axes)
    : fonts_(fonts),
      list_(*ImGui::GetWindowDrawList()),
      paper_(paper),
      x_{axes.x, paper.corner.x, paper.corner.x + paper.size.x},
      y_{axes.y, paper.corner.y + paper.size.y, paper.corner.y} {
  const ImVec2 end{paper.corner.x + paper.size.x, paper.corner.y + paper.size.y};
  list_.AddRectFilled(paper.corner, end, paper_color());
  draw_axes(axes);
  list_.PushClipRect(paper.corner, end, true);
}

Plot::~Plot() {
  list_.PopClipRect();
  list_.AddRect(paper_.corner, {paper_.corner.x + paper_.size.x, paper_.corner.y + paper_.size.y},
                kLine);
}

void Plot::draw_axes(const PlotAxes& axes) const {
  constexpr int kMost = 8;
  const PlotColors colors = plot_colors();
  const float em = ImGui::GetFontSize();
  const float left = paper_.corner.x, right = left + paper_.size.x;
  const float top = paper_.corner.y, bottom = top + paper_.size.y;
  const auto size = [&](const std::string& text) { return small_text_size(fonts_, text); };
  const auto width = [&](const std::string& text) { return size(text).x; };
  const auto shiftable = [&](const std::string& text) { return 1.5f * width(text); };
  const auto height = [&](const std::string& text) { return size(text).y; };
  for (const Tick& tick : ticks_that_fit(y_, kMost / 2, 0.4f * em, height, axes.y_least)) {
    const float y = y_.place(tick.value);
    const bool zero = tick.value == 0 && axes.y.low < 0;
    list_.AddLine({left, y}, {right, y}, zero ? colors.zero : colors.grid);
    const ImVec2 extent = size(tick.text);
    const float lowest = bottom - extent.y + 0.15f * em;  // not among the labels of x
    small_text(list_, fonts_,
               {left - extent.x - 0.3f * em,
                std::clamp(y - extent.y / 2, top - 0.15f * em, std::max(lowest, top))},
               kFaint, tick.text);
  }
  for (const Tick& tick : ticks_that_fit(x_, kMost, 0.8f * em, shiftable, axes.x_least)) {
    const float x = x_.place(tick.value);
    list_.AddLine({x, top}, {x, bottom}, colors.grid);
    if (!axes.x_labels) continue;
    const float extent = width(tick.text);
    const float shift = std::clamp(x - extent / 2, left, std::max(right - extent, left));
    small_text(list_, fonts_, {shift, bottom + 0.15f * em}, kFaint, tick.text);
  }
  if (axes.x_celsius) draw_celsius();
}

/// A second row of labels below the paper, with ticks of their own.
void Plot::draw_celsius() const {
  constexpr int kMost = 8;
  const float em = ImGui::GetFontSize(), bottom = y_.from;
  const Axis degrees{{io::celsius(x_.values.low), io::celsius(x_.values.high)}, x_.from, x_.to};
  const auto text_of = [](const Tick& tick) { return tick.text + " \u00b0C"; };
  const auto width = [&](const std::string& text) {
    return 1.5f * small_text_size(fonts_, text + " \u00b0C").x;  // labels at the ends are moved
  };
  for (const Tick& tick : ticks_that_fit(degrees, kMost, 0.4f * em, width)) {
    const float x = degrees.place(tick.value);
    const ImVec2 extent = small_text_size(fonts_, text_of(tick));
    const float most = std::max(x_.to - extent.x, x_.from);
    list_.AddLine({x, bottom - 0.25f * em}, {x, bottom}, kFaint);
    small_text(list_, fonts_,
               {std::clamp(x - extent.x / 2, x_.from, most), bottom + 0.15f * em + extent.y},
               kFaint, text_of(tick));
  }
}

void Plot::curve(std::span<const Column> curve, ImU32 color, float thickness) const {
  const float width = thickness * line_width();
  // Single lines: the joints of a polyline would shoot out where the curve jumps.
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Column& here = curve[i];
    if (i > 0) {
      list_.AddLine({curve[i - 1].x, y_.place(curve[i - 1].last)}, {here.x, y_.place(here.first)},
                    color, width);
    }
    const float low = y_.place(here.low), high = y_.place(here.high);
    if (low - high > 1) list_.AddLine({here.x, low}, {here.x, high}, color, width);
  }
}

void Plot::band(std::span<const Column> curve, ImU32 color) const {
  // Without smooth edges neighbours share theirs, and no seam shows.
  const ImDrawListFlags flags = list_.Flags;
  list_.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Column &a = curve[i - 1], &b = curve[i];
    list_.AddQuadFilled({a.x, y_.place(a.high)}, {b.x, y_.place(b.high)}, {b.x, y_.place(b.low)},
                        {a.x, y_.place(a.low)}, color);
  }
  list_.Flags = flags;
}

void Plot::bars(const Histogram& bars, ImU32 color) const {
  const double width = (bars.range.high - bars.range.low) / static_cast<double>(bars.counts.size());
  for (std::size_t i = 0; i < bars.counts.size(); ++i) {
    if (bars.counts[i] == 0) continue;
    const double low = bars.range.low + width * static_cast<double>(i);
    const float left = x_.place(low), right = x_.place(low + width);
    const float gap = right - left > 4 ? 1.0f : 0.0f;
    list_.AddRectFilled({left, y_.place(bars.counts[i])},
                        {std::max(right - gap, left + 1), y_.place(0)}, color);
  }
}

void Plot::across(double y, ImU32 color) const {
  const float at = y_.place(y), dash = 0.35f * ImGui::GetFontSize();
  for (float x = paper_.corner.x; x < paper_.corner.x + paper_.size.x; x += 2 * dash) {
    list_.AddLine({x, at}, {x + dash, at}, color, line_width());
  }
}

void Plot::upright(double x, ImU32 color, bool dashed) const {
  const float at = x_.place(x), dash = 0.3f * ImGui::GetFontSize();
  const float bottom = paper_.corner.y + paper_.size.y;
  if (!dashed) {
    list_.AddLine({at, paper_.corner.y}, {at, bottom}, color);
    return;
  }
  for (float y = paper_.corner.y; y < bottom; y += 2 * dash) {
    list_.AddLine({at, y}, {at, y + dash}, color, line_width());
  }
}

void Plot::stretch(double low, double high, ImU32 color) const {
  list_.AddRectFilled({x_.place(low), paper_.corner.y},
                      {x_.place(high), paper_.corner.y + paper_.size.y}, color);
}

void Plot::dot(double x, double y, ImU32 color) const {
  list_.AddCircleFilled({x_.place(x), y_.place(y)}, 0.28f * ImGui::GetFontSize(), color);
}

void Plot::text(double x, double y, ImU32 color, const std::string& text, float lift) const {
  const ImVec2 size = small_text_size(fonts_, text);
  const float edge = 0.2f * ImGui::GetFontSize();
  const auto within = [&](float place, float low, float room, float extent) {
    return std::clamp(place - extent / 2, low + edge,
                      std::max(low + room - extent - edge, low + edge));
  };
  small_text(list_, fonts_,
             {within(x_.place(x), paper_.corner.x, paper_.size.x, size.x),
              within(y_.place(y) - lift, paper_.corner.y, paper_.size.y, size.y)},
             color, text);
}

}  // namespace pupflow::window
