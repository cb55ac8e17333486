#include "app/window/panels/legend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/text_line.h"

namespace pupflow::window {
namespace {

ImVec2 place(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}

void draw_label(ImDrawList& list, ImFont& font, const view::ColorBar::Label& label, ImU32 ink) {
  const double x = aligned(font, label.x, label.text, label.size, label.align);
  const int first = list.VtxBuffer.Size;
  draw_line(list, font, x, label.y, label.text, label.size, ink);
  if (!label.upwards) return;
  // A quarter turn counter-clockwise about the middle of the baseline.
  const ImVec2 middle = place(label.x, label.y);
  for (int i = first; i < list.VtxBuffer.Size; ++i) {
    ImVec2& vertex = list.VtxBuffer[i].pos;
    vertex = {middle.x + (vertex.y - middle.y), middle.y - (vertex.x - middle.x)};
  }
}

void paint_wheel(ImDrawList& list, const view::ColorBar::Wheel& wheel) {
  constexpr int kSteps = 96;
  const auto at = [&](double angle, double radius) {
    return place(wheel.centre.x() + radius * std::cos(angle),
                 wheel.centre.y() - radius * std::sin(angle));
  };
  for (int i = 0; i < kSteps; ++i) {
    const double step = 2 * std::numbers::pi / kSteps, begin = i * step - std::numbers::pi;
    list.AddQuadFilled(at(begin, wheel.inner), at(begin, wheel.outer),
                       at(begin + step, wheel.outer), at(begin + step, wheel.inner),
                       packed(view::wheel_color(wheel, begin + step / 2)));
  }
}

}  // namespace

void paint_legend(ImDrawList& list, const view::ColorBar& layout, ImU32 ink, ImU32 line) {
  const auto low = [](const view::Box& box) { return place(box.x, box.y); };
  const auto high = [](const view::Box& box) {
    return place(box.x + box.width, box.y + box.height);
  };
  for (const auto& fill : layout.fills) {
    list.AddRectFilled(low(fill.box), high(fill.box), packed(fill.color));
  }
  for (const view::Box& box : layout.frames) list.AddRect(low(box), high(box), line);
  for (const auto& s : layout.strokes) {
    list.AddLine(place(s.x0, s.y0), place(s.x1, s.y1), line, static_cast<float>(s.width));
  }
  for (const auto& [corners, color] : layout.triangles) {
    list.AddTriangleFilled(place(corners[0].x(), corners[0].y()),
                           place(corners[1].x(), corners[1].y()),
                           place(corners[2].x(), corners[2].y()), color ? packed(*color) : ink);
  }
  if (layout.wheel) paint_wheel(list, *layout.wheel);
  for (const auto& label : layout.labels) draw_label(list, *ImGui::GetFont(), label, ink);
}

void draw_bare_legend(const Area& strip, const view::ColorScale& scale, double tp) {
  const float em = ImGui::GetFontSize();
  view::ColorBarStyle style;
  style.text_size = static_cast<double>(em);
  view::ColorBarMargins margins = view::color_bar_margins(scale, style);
  // Smaller where the strip is narrow.
  const auto needed = static_cast<float>(margins.left + margins.right) + em;
  style.text_size *= static_cast<double>(std::min(1.0f, strip.size.x / needed));
  margins = view::color_bar_margins(scale, style);
  const auto size = static_cast<float>(style.text_size);
  // The title stays at the strip's edge, whatever the labels are.
  margins.right = static_cast<int>(strip.size.x - 1.3f * size) - margins.left;
  const float height = std::min(22 * size, 0.6f * strip.size.y);
  const view::Box bar{static_cast<int>(strip.corner.x) + margins.left,
                      static_cast<int>(strip.middle().y - height / 2), static_cast<int>(size),
                      static_cast<int>(height)};
  paint_legend(*ImGui::GetBackgroundDrawList(),
               view::lay_out_color_bar(bar, margins, scale, tp, style), kPaperInk, kPaperFaint);
}

}  // namespace pupflow::window
