#include "app/window/panels/legend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pupflow::window {
namespace {

constexpr double kSubscriptSize = 0.75, kSubscriptDrop = 0.2;  // of the text size

ImU32 packed(view::Rgb color) {
  return IM_COL32(color.r, color.g, color.b, 255);
}

ImVec2 place(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}

double size_of(const view::TextRun& run, double size) {
  return run.style == view::TextRun::Style::subscript ? kSubscriptSize * size : size;
}

double width_of(const view::TextLine& line, double size, const ImFont& font) {
  double width = 0;
  for (const view::TextRun& run : line) {
    const auto em = static_cast<float>(size_of(run, size));
    width += static_cast<double>(font.CalcTextSizeA(em, FLT_MAX, 0, run.text.c_str()).x);
  }
  return width;
}

/// Draws `line` from (x, y), the left end of its baseline.
void draw_line(ImDrawList& list, const ImFont& font, double x, double y, const view::TextLine& line,
               double size) {
  for (const view::TextRun& run : line) {
    const double em = size_of(run, size);
    const bool lowered = run.style == view::TextRun::Style::subscript;
    const double ascent = static_cast<double>(font.Ascent / font.FontSize) * em;
    list.AddText(&font, static_cast<float>(em),
                 place(x, y - ascent + (lowered ? kSubscriptDrop * size : 0)), kPaperInk,
                 run.text.c_str());
    x += width_of({run}, size, font);
  }
}

void draw_label(ImDrawList& list, const ImFont& font, const view::ColorBar::Label& label) {
  const double share = label.align == view::Align::left     ? 0
                       : label.align == view::Align::centre ? 0.5
                                                            : 1;
  const double x = label.x - share * width_of(label.text, label.size, font);
  const int first = list.VtxBuffer.Size;
  draw_line(list, font, x, label.y, label.text, label.size);
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

void paint(ImDrawList& list, const ImFont& font, const view::ColorBar& layout) {
  const auto low = [](const view::Box& box) { return place(box.x, box.y); };
  const auto high = [](const view::Box& box) {
    return place(box.x + box.width, box.y + box.height);
  };
  for (const auto& fill : layout.fills) {
    list.AddRectFilled(low(fill.box), high(fill.box), packed(fill.color));
  }
  for (const view::Box& box : layout.frames) list.AddRect(low(box), high(box), kPaperFaint);
  for (const auto& s : layout.strokes) {
    list.AddLine(place(s.x0, s.y0), place(s.x1, s.y1), kPaperFaint, static_cast<float>(s.width));
  }
  for (const auto& [corners, color] : layout.triangles) {
    list.AddTriangleFilled(
        place(corners[0].x(), corners[0].y()), place(corners[1].x(), corners[1].y()),
        place(corners[2].x(), corners[2].y()), color ? packed(*color) : kPaperInk);
  }
  if (layout.wheel) paint_wheel(list, *layout.wheel);
  for (const auto& label : layout.labels) draw_label(list, font, label);
}

}  // namespace

void draw_legend(const Area& strip, const view::ColorScale& scale, double tp, const Fonts& fonts) {
  const float em = ImGui::GetFontSize();
  view::ColorBarStyle style;
  style.text_size = static_cast<double>(em);
  view::ColorBarMargins margins = view::color_bar_margins(scale, style);
  // The title stays at the strip's edge, whatever the labels are.
  margins.right = static_cast<int>(strip.size.x - 1.3f * em) - margins.left;
  const float height = std::min(22 * em, 0.6f * strip.size.y);
  const view::Box bar{static_cast<int>(strip.corner.x) + margins.left,
                      static_cast<int>(strip.middle().y - height / 2), static_cast<int>(em),
                      static_cast<int>(height)};
  paint(*ImGui::GetBackgroundDrawList(), *fonts.text,
        view::lay_out_color_bar(bar, margins, scale, tp, style));
}

}  // namespace pupflow::window
