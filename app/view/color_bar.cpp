#include "app/view/color_bar.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "app/io/celsius.h"

namespace pupflow::view {

namespace {

constexpr double kTick = 0.35, kGap = 0.3, kTitle = 1.15;  // of the text size
constexpr int kTicks = 5;
constexpr double kTickText = 0.36;  // from a tick down to its label's baseline
constexpr const char* kNobody = "nobody";
constexpr const char* kUnknown = "unknown";

struct Tick {
  double value;
  std::string label;
};

/// Whether the bar has a second axis in degrees.
bool has_celsius(const ColorScale& scale, const ColorBarStyle& style) {
  return style.celsius && scale.is_temperature();
}

std::vector<Tick> celsius_ticks(const ColorScale& scale) {
  std::vector<Tick> ticks;
  for (const double degrees : round_ticks(io::celsius(scale.min), io::celsius(scale.max), kTicks)) {
    ticks.push_back({degrees / io::kCelsiusPerUnit, tick_label(degrees)});
  }
  return ticks;
}

std::vector<Tick> ticks_of(const ColorScale& scale) {
  std::vector<Tick> ticks;
  const double least = scale.field->digits == 0 ? 1 : 0;
  for (const double value : round_ticks(scale.min, scale.max, kTicks, least)) {
    ticks.push_back({value, tick_label(value)});
  }
  return ticks;
}

/// The label of a swatch. Where colors repeat it names all categories of that color.
std::string category_label(const ColorScale& scale, int category) {
  if (category < 0) return kNobody;
  const auto names = scale.field->categories;
  if (!names.empty()) return std::string(names[static_cast<std::size_t>(category)]);
  std::string label = std::to_string(category);
  if (category + kCategoryColors <= scale.max) {
    label += ", " + std::to_string(category + kCategoryColors);
  }
  if (category + 2 * kCategoryColors <= scale.max) label += ", \u2026";
  return label;
}

std::size_t length(const std::string& label) {
  return static_cast<std::size_t>(std::count_if(
      label.begin(), label.end(), [](char c) { return (static_cast<int>(c) & 0xc0) != 0x80; }));
}

/// Characters of the longest label in degrees, as far as it is known before the data. T_p and "°C"
/// need no more room.
double longest_celsius(const ColorScale& scale) {
  std::size_t longest = 5;  // "−12.5"
  if (scale.is_fitted() && (scale.ends == Ends::field || scale.ends == Ends::typed)) {
    longest = 3;
    for (const Tick& tick : celsius_ticks(scale)) longest = std::max(longest, length(tick.label));
  }
  return static_cast<double>(longest);
}

/// Characters of the longest label, as far as it is known before the data.
std::size_t longest_label(const ColorScale& scale) {
  constexpr std::size_t kOfData = 6;
  std::size_t longest = 0;
  if (scale.categorical()) {
    longest = kOfData;
    for (const std::string_view name : scale.field->categories) {
      longest = std::max(longest, name.size());
    }
  } else if (!scale.is_fitted()) {
    longest = kOfData;
  } else {
    for (const Tick& tick : ticks_of(scale)) longest = std::max(longest, length(tick.label));
    if (scale.ends != Ends::field) longest = std::max(longest, kOfData);
  }
  return longest;
}

void add_swatch(ColorBar& layout, const Box& box, Rgb color, const std::string& label,
                double size) {
  layout.fills.push_back({box, color});
  layout.frames.push_back({box.x - 1, box.y - 1, box.width + 2, box.height + 2});
  layout.labels.push_back({box.x + box.width + 1 + (kTick + kGap) * size,
                           box.y + box.height / 2.0 + kTickText * size,
                           {{label}},
                           size});
}

/// One swatch below the other from the top of the bar.
void add_categories(ColorBar& layout, const Box& bar, const ColorScale& scale, double size) {
  const int first = static_cast<int>(std::lround(scale.min));
  const int last = std::min(static_cast<int>(std::lround(scale.max)), kCategoryColors - 1);
  const double row = std::min(1.7 * size, static_cast<double>(bar.height) / (last - first + 1));
  const int side = std::max(2, static_cast<int>(0.75 * row));
  for (int category = first; category <= last; ++category) {
    const int y = bar.y + static_cast<int>(std::lround((category - first) * row));
    add_swatch(layout, {bar.x, y, bar.width, side}, scale(category),
               category_label(scale, category), size);
  }
}

/// How thick ticks are.
double stroke_of(double size) {
  return std::max(1.0, std::round(size / 14));
}

/// Triangles in the colors of the ends beyond which there are values.
void add_ends(ColorBar& layout, const Box& bar, const ColorScale& scale) {
  const double left = bar.x - 1, right = bar.x + bar.width + 1, middle = (left + right) / 2;
  const double height = 0.7 * bar.width, top = bar.y - 1, bottom = bar.y + bar.height + 1;
  if (scale.above) {
    layout.triangles.push_back(
        {{{left, top}, {right, top}, {middle, top - height}}, scale(scale.max)});
  }
  if (scale.below) {
    layout.triangles.push_back(
        {{{left, bottom}, {right, bottom}, {middle, bottom + height}}, scale(scale.min)});
  }
}

/// Degrees to the left of the bar. A tick that T_p would touch is left out.
void add_celsius(ColorBar& layout, const Box& bar, const ColorScale& scale, double tp, double size,
                 const auto& height_of) {
  const double left = bar.x - 1, tick_end = left - kTick * size, stroke = stroke_of(size);
  const double taken = height_of(std::clamp(tp, scale.min, scale.max));
  const double beside = tp < scale.min || tp > scale.max ? 2.2 * size : 1.1 * size;
  for (const Tick& tick : celsius_ticks(scale)) {
    const double y = height_of(tick.value);
    if (std::abs(y - taken) < beside) continue;
    layout.strokes.push_back({tick_end, y, left, y, stroke});
    layout.labels.push_back(
        {tick_end - kGap * size, y + kTickText * size, {{tick.label}}, size, Align::right});
  }
  layout.labels.push_back(
      {left - kGap * size, bar.y - 0.9 * size, {{"\u00b0C"}}, size, Align::right});
}

void add_bar(ColorBar& layout, const Box& bar, const ColorScale& scale, double tp,
             const ColorBarStyle& style) {
  const double size = style.text_size;
  const double stroke = stroke_of(size);
  for (int row = 0; row < bar.height; ++row) {
    const double share = 1 - (row + 0.5) / bar.height;
    layout.fills.push_back(
        {{bar.x, bar.y + row, bar.width, 1}, scale(scale.min + share * (scale.max - scale.min))});
  }
  layout.frames.push_back({bar.x - 1, bar.y - 1, bar.width + 2, bar.height + 2});

  // A power of two changes no digit, and keeps the height times the largest scale finite.
  constexpr double kSmall = 0x1p-20;
  const auto height_of = [&](double value) {
    const double below_top = kSmall * scale.max - kSmall * value;
    const double all = kSmall * scale.max - kSmall * scale.min;
    return std::floor(bar.y + bar.height * below_top / all) + 0.5;
  };
  const double right = bar.x + bar.width + 1, tick_end = right + kTick * size;
  for (const Tick& tick : ticks_of(scale)) {
    const double y = height_of(tick.value);
    layout.strokes.push_back({right, y, tick_end, y, stroke});
    layout.labels.push_back({tick_end + kGap * size, y + kTickText * size, {{tick.label}}, size});
  }
  const auto line_across = [&](double value) {
    const double y = height_of(value);
    layout.strokes.push_back(
        {static_cast<double>(bar.x), y, static_cast<double>(bar.x + bar.width), y, stroke});
  };
  const auto on_scale = [&](double value) { return value >= scale.min && value <= scale.max; };
  if (scale.field->kind == FieldKind::signed_ && on_scale(scale.field->centre)) {
    line_across(scale.field->centre);
  }
  add_ends(layout, bar, scale);
  if (!scale.is_temperature()) return;
  if (style.celsius) add_celsius(layout, bar, scale, tp, size, height_of);
  const double tip = bar.x - 2, head = 0.45 * size;
  if (on_scale(tp)) {
    // An arrow head from the left, so that it never meets a tick's label.
    const double y = height_of(tp);
    layout.triangles.push_back(
        {{{tip, y}, {tip - head, y - 0.25 * size}, {tip - head, y + 0.25 * size}}, {}});
    line_across(tp);
    layout.labels.push_back(
        {tip - 0.75 * size, y + 0.3 * size, symbol("T", "p"), size, Align::right});
    return;
  }
  // An arrow head at the end beyond which it lies, and its value.
  const bool up = tp > scale.max;
  const double towards = up ? -1 : 1, x = tip - 0.95 * size;
  const double y = up ? bar.y : bar.y + bar.height;
  layout.triangles.push_back(
      {{{x, y}, {x - 0.3 * size, y - towards * head}, {x + 0.3 * size, y - towards * head}}, {}});
  layout.labels.push_back({x + 0.65 * size, y - towards * head + (up ? 1.05 : -0.35) * size,
                           symbol("T", "p"), size, Align::right});
}

/// Tick of an angle.
void add_wheel_label(ColorBar& layout, double x, double y, const char* text, double size,
                     Align align) {
  layout.labels.push_back({x, y + kTickText * size, {{text}}, size, align});
}

/// Where an angle points on the wheel it points in the arena seen from above.
void add_wheel(ColorBar& layout, const Box& bar, const ColorScale& scale, double size) {
  const double outer = 1.6 * size, gap = 0.3 * size;
  const Eigen::Vector2d centre(bar.x + 2 * size, bar.y + bar.height / 2.0);
  layout.wheel = ColorBar::Wheel{centre, 0.55 * outer, outer, scale.map};
  add_wheel_label(layout, centre.x() + outer + gap, centre.y(), "0", size, Align::left);
  add_wheel_label(layout, centre.x(), centre.y() - outer - gap - 0.4 * size, "π/2", size,
                  Align::centre);
  add_wheel_label(layout, centre.x() - outer - gap, centre.y(), "π", size, Align::right);
  add_wheel_label(layout, centre.x(), centre.y() + outer + gap + 0.4 * size, "\u2212π/2", size,
                  Align::centre);
}

}  // namespace

std::string tick_label(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6)
          .ptr;
  std::string label(text.data(), end);
  if (label.starts_with('-')) label.replace(0, 1, "\u2212");  // a real minus sign
  return label;
}

TextLine title_of(const Field& field) {
  TextLine title{{std::string(field.label)}};
  if (!field.symbol.empty()) {
    title.front().text += ' ';
    title = title + symbol(field.symbol);
  }
  if (!field.unit.empty()) title = title + (" (" + std::string(field.unit) + ")");
  return title;
}

ColorBarMargins color_bar_margins(const ColorScale& scale, const ColorBarStyle& style) {
  constexpr double kDigit = 0.64;  // width of a character, of the text size
  const double labels = kTick + kGap + kDigit * static_cast<double>(longest_label(scale));
  const double right = style.titled ? std::max(5.0, labels + 1.6 * kTitle) : labels;
  const double left =
      has_celsius(scale, style) ? kTick + kGap + kDigit * longest_celsius(scale) : 2.1;
  const int beside_bar = has_celsius(scale, style) ? 2 : 0;  // pixels; ticks begin one off the bar
  return {beside_bar + static_cast<int>(std::lround(left * style.text_size)),
          static_cast<int>(std::lround(right * style.text_size))};
}

double color_bar_room(const ColorScale& scale, const ColorBarStyle& style, TextPainter& text) {
  constexpr double kOfTicks = 8, kOfTitle = 13;  // of the text size
  const double size = style.text_size;
  if (!scale.categorical()) {
    return std::max(kOfTicks * size, text.width(title_of(*scale.field), kTitle * size));
  }
  const std::size_t named = scale.field->categories.size();
  const double swatches = named > 0 ? static_cast<double>(named) : kCategoryColors;
  return size * std::max(kOfTitle, swatches / 0.75);
}

ColorBar lay_out_color_bar(const Box& bar, const ColorBarMargins& margins, const ColorScale& scale,
                           double tp, const ColorBarStyle& style) {
  ColorBar layout;
  const double size = style.text_size;
  if (scale.categorical()) {
    add_categories(layout, bar, scale, size);
  } else if (scale.field->kind == FieldKind::angle) {
    add_wheel(layout, bar, scale, size);
  } else {
    add_bar(layout, bar, scale, tp, style);
  }
  if (scale.unknown) {
    const int side = static_cast<int>(1.2 * size);
    add_swatch(layout, {bar.x, bar.y + bar.height + side, bar.width, side}, kUnknownColor, kUnknown,
               size);
  }
  if (!style.titled) return layout;
  // The title: over the swatches, or along the bar.
  if (scale.categorical()) {
    layout.labels.push_back(
        {static_cast<double>(bar.x), bar.y - 0.8 * size, title_of(*scale.field), size});
  } else {
    layout.labels.push_back({bar.x + bar.width + margins.right - 0.4 * kTitle * size,
                             bar.y + bar.height / 2.0, title_of(*scale.field), kTitle * size,
                             Align::centre, true});
  }
  return layout;
}

namespace {

void draw_wheel(io::Image& image, const ColorBar::Wheel& wheel) {
  const auto first = [&](double at) { return static_cast<int>(std::floor(at - wheel.outer - 1)); };
  const auto last = [&](double at) { return static_cast<int>(std::ceil(at + wheel.outer + 1)); };
  for (int y = first(wheel.centre.y()); y < last(wheel.centre.y()); ++y) {
    for (int x = first(wheel.centre.x()); x < last(wheel.centre.x()); ++x) {
      const Eigen::Vector2d away = Eigen::Vector2d(x + 0.5, y + 0.5) - wheel.centre;
      const double r = away.norm();
      const double cover = std::min(wheel.outer - r, r - wheel.inner) + 0.5;
      if (cover <= 0) continue;
      blend(image, x, y, wheel_color(wheel, std::atan2(-away.y(), away.x())), std::min(cover, 1.0));
    }
  }
}

}  // namespace

Rgb wheel_color(const ColorBar::Wheel& wheel, double angle) {
  const double turn = angle / (2 * std::numbers::pi) + 0.5;
  const auto index = static_cast<std::size_t>(std::clamp(turn, 0.0, 1.0) * kColormapSize);
  return wheel.map[std::min<std::size_t>(index, kColormapSize - 1)];
}

void draw_color_bar(io::Image& image, TextPainter& text, const ColorBar& layout, Rgb ink) {
  for (const ColorBar::Fill& part : layout.fills) fill(image, part.box, part.color);
  for (const Box& box : layout.frames) frame(image, box, 1, ink);
  for (const ColorBar::Stroke& s : layout.strokes)
    line(image, s.x0, s.y0, s.x1, s.y1, s.width, ink);
  for (const ColorBar::Triangle& triangle : layout.triangles) {
    fill(image, triangle.corners, triangle.color.value_or(ink), 1);
  }
  if (layout.wheel) draw_wheel(image, *layout.wheel);
  for (const ColorBar::Label& label : layout.labels) {
    if (label.upwards) {
      text.draw_upwards(image, label.x, label.y, label.text, label.size, ink);
    } else {
      text.draw(image, label.x, label.y, label.text, label.size, ink, label.align);
    }
  }
}

}  // namespace pupflow::view
