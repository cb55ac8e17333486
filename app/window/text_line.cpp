#include "app/window/text_line.h"

#include "app/window/imgui_compat.h"

namespace pupflow::window {
namespace {

constexpr double kSubscriptSize = 0.75, kSubscriptDrop = 0.2;  // of the text size

bool lowered(const view::TextRun& run) {
  return run.style == view::TextRun::Style::subscript;
}

double width_of(ImFont& font, const view::TextRun& run, double size) {
  const auto em = static_cast<float>(lowered(run) ? kSubscriptSize * size : size);
  return static_cast<double>(font.CalcTextSizeA(em, FLT_MAX, 0, run.text.c_str()).x);
}

}  // namespace

double width_of(ImFont& font, const view::TextLine& line, double size) {
  double width = 0;
  for (const view::TextRun& run : line) width += width_of(font, run, size);
  return width;
}

void draw_line(ImDrawList& list, ImFont& font, double x, double y, const view::TextLine& line,
               double size, ImU32 color) {
  for (const view::TextRun& run : line) {
    const double em = lowered(run) ? kSubscriptSize * size : size;
    const double rise = static_cast<double>(ascent(font) / pixel_size(font)) * em;
    const double top = y - rise + (lowered(run) ? kSubscriptDrop * size : 0);
    list.AddText(&font, static_cast<float>(em), {static_cast<float>(x), static_cast<float>(top)},
                 color, run.text.c_str());
    x += width_of(font, run, size);
  }
}

double aligned(ImFont& font, double x, const view::TextLine& line, double size, view::Align align) {
  if (align == view::Align::left) return x;
  return x - (align == view::Align::centre ? 0.5 : 1) * width_of(font, line, size);
}

}  // namespace pupflow::window
