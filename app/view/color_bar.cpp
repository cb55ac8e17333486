#include "app/view/color_bar.h"

#include <array>
#include <charconv>
#include <cmath>

namespace pupflow::view {

namespace {

constexpr double kTick = 0.35, kGap = 0.3, kTitle = 1.15;  // of the text size

}  // namespace

std::vector<double> round_ticks(double low, double high, int count) {
  const double rough = (high - low) / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= 0.999 * rough) step = factor * power;
  }
  std::vector<double> ticks;
  const auto first = std::llround(std::ceil(low / step - 1e-9));
  const auto last = std::llround(std::floor(high / step + 1e-9));
  for (auto i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

std::string tick_label(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6)
          .ptr;
  std::string label(text.data(), end);
  if (label.starts_with('-')) label.replace(0, 1, "\u2212");  // a real minus sign
  return label;
}

ColorBarMargins color_bar_margins(const ColorBarStyle& style) {
  return {static_cast<int>(std::lround(2.1 * style.text_size)),
          static_cast<int>(std::lround(5.0 * style.text_size))};
}

void draw_color_bar(io::Image& image, TextPainter& text, const Box& bar, const ColorScale& scale,
                    double tp, const ColorBarStyle& style) {
  const double size = style.text_size, stroke = std::max(1.0, std::round(size / 14));
  for (int row = 0; row < bar.height; ++row) {
    const double share = 1 - (row + 0.5) / bar.height;
    fill(image, {bar.x, bar.y + row, bar.width, 1},
         scale(scale.min + share * (scale.max - scale.min)));
  }
  frame(image, {bar.x - 1, bar.y - 1, bar.width + 2, bar.height + 2}, 1, style.ink);

  const auto height_of = [&](double value) {
    return bar.y + bar.height * (scale.max - value) / (scale.max - scale.min);
  };
  const double right = bar.x + bar.width + 1, tick_end = right + kTick * size;
  for (const double tick : round_ticks(scale.min, scale.max, 5)) {
    const double y = std::floor(height_of(tick)) + 0.5;
    line(image, right, y, tick_end, y, stroke, style.ink);
    text.draw(image, tick_end + kGap * size, y + 0.36 * size, {{tick_label(tick)}}, size,
              style.ink);
  }
  if (tp >= scale.min && tp <= scale.max) {
    // An arrow head from the left, so that it never meets a tick's label.
    const double y = std::floor(height_of(tp)) + 0.5, tip = bar.x - 2;
    for (int step = 0; step <= std::lround(0.45 * size); ++step) {
      line(image, tip - step - 1, y - 0.55 * step, tip - step - 1, y + 0.55 * step + 0.01, 1,
           style.ink);
    }
    line(image, bar.x, y, bar.x + bar.width, y, stroke, style.ink);
    text.draw(image, tip - 0.75 * size, y + 0.3 * size, symbol("T", "p"), size, style.ink,
              Align::right);
  }
  text.draw_upwards(image, bar.x + bar.width + color_bar_margins(style).right - 0.4 * kTitle * size,
                    bar.y + bar.height / 2.0, TextLine{{"body temperature "}} + symbol("T", "b"),
                    kTitle * size, style.ink);
}

}  // namespace pupflow::view
