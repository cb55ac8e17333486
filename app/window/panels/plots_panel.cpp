#include "app/window/panels/plots_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "app/io/text.h"
#include "app/window/history_csv.h"
#include "app/window/panels/celsius.h"
#include "app/window/panels/choice.h"
#include "app/window/panels/list_rows.h"
#include "app/window/panels/plot_curves.h"

namespace pupflow::window {
namespace {

/// A stretch of model time.
struct PlotSpan {
  double seconds;
  const char* text;
};

constexpr double kWholeRun = std::numeric_limits<double>::infinity();
constexpr std::array<PlotSpan, 5> kSpans{
    {{10, "10 s"}, {30, "30 s"}, {60, "1 min"}, {300, "5 min"}, {kWholeRun, "whole run"}}};

/// Means of rates, which jump from step to step, are drawn over so many seconds.
constexpr std::array<PlotSpan, 5> kSmoothings{{{0, "raw flow"},
                                               {0.1, "flow: 0.1 s"},
                                               {0.5, "flow: 0.5 s"},
                                               {2, "flow: 2 s"},
                                               {10, "flow: 10 s"}}};

constexpr float kTitleLines = 1.3f, kGapLines = 0.3f;

/// Height of a paper in lines of text. T_b has more in it than the others.
float paper_lines(const ObservableField& row) {
  return row.observable == Observable::mean_tb ? 5.5f : 3.1f;
}

bool is_rate(const ObservableField& row) {
  return row.unit == "1/s";
}

bool is_temperature(const ObservableField& row) {
  return row.observable == Observable::mean_tb;
}

void draw_spans(const char* name, const char* doc, float width, std::span<const PlotSpan> spans,
                std::size_t& chosen, const PanelInput& in) {
  in.events.note(name, spans[chosen].text);
  const auto choices = [&](const auto& choice) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (choice(std::to_string(i), spans[i].text, "", i == chosen)) chosen = i;
    }
  };
  draw_choice(name, spans[chosen].text, doc, in, choices, width);
}

/// A number and its color, at the right of a plot's title.
struct Reading {
  std::string text;
  ImU32 color;
};

/// The title left and the readings right; where both have no room the title gives way.
void draw_title(const Fonts& fonts, const ObservableField& row, ImVec2 corner, float width,
                const std::vector<Reading>& readings) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize();
  float right = corner.x + width;
  for (const Reading& reading : readings) {
    right -= ImGui::CalcTextSize(reading.text.c_str()).x;
    list.AddText({right, corner.y}, reading.color, reading.text.c_str());
    right -= 0.7f * em;
  }
  std::string label(row.label);
  if (!row.unit.empty()) label += " (" + std::string(row.unit) + ')';
  for (const std::string& text : {label, std::string(row.label), std::string(row.symbol)}) {
    if (ImGui::CalcTextSize(text.c_str()).x > right - corner.x) continue;
    draw_rich_text(list, fonts, corner, kInk, text);
    return;
  }
}

}  // namespace

/// What all plots of one frame share.
struct PlotsPanel::Frame {
  Range time;                     // on the x axis
  double now;                     // what the arena shows
  float left, width;              // of the papers
  std::optional<double> pointed;  // the time under the mouse
  const Timeline::Mark* mark;     // under the mouse
  double dt;
  std::vector<History::Entry> first, second;
  std::optional<int> selected;

  Axis axis() const { return {time, left, left + width}; }
};

Range shown_time(double begin, double end, double now, double seconds) {
  constexpr double kLeast = 1;
  if (!std::isfinite(seconds)) return {begin, std::max(end, begin + kLeast)};
  const double high = std::max(std::min(end, now + seconds / 2), begin + seconds);
  return {high - seconds, high};
}

double PlotsPanel::window_of(std::size_t observable) const {
  return is_rate(observables()[observable]) ? kSmoothings[smoothing_].seconds : 0;
}

void PlotsPanel::draw(const PanelInput& in) {
  const LiveState& state = in.state;
  const LitterView litter = state.view();
  Frame frame{};
  frame.dt = litter.params.dt;
  frame.now = litter.time;
  frame.left = ImGui::GetCursorScreenPos().x + plot_margin_left();
  frame.width = std::max(ImGui::GetContentRegionAvail().x - plot_margin_left(), 10.0f);
  frame.selected = in.controls.selected;
  const History& history = state.history;
  const auto time_of = [&](std::int64_t step) { return static_cast<double>(step) * frame.dt; };
  const double begin = history.empty() ? frame.now : time_of(history.first() - 1);
  const double end = history.empty() ? frame.now : std::max(frame.now, time_of(history.last()));
  frame.time = shown_time(begin, end, frame.now, kSpans[span_].seconds);
  const auto entries = [&](const History& of) {
    const double before = frame.time.low - kSmoothings[smoothing_].seconds;
    return of.between(std::llround(before / frame.dt), std::llround(frame.time.high / frame.dt));
  };
  frame.first = entries(history);
  if (state.second) frame.second = entries(state.second->history);

  draw_choices(in, frame);
  follow_mouse(frame);
  for (const Timeline::Mark& mark : state.timeline.marks) {
    if (!frame.pointed) break;
    const float away = frame.axis().place(time_of(mark.step)) - frame.axis().place(*frame.pointed);
    if (std::abs(away) < 0.4f * ImGui::GetFontSize()) frame.mark = &mark;
  }
  if (in.events.on()) {
    in.events.note("pointed", frame.pointed ? io::formatted("%.3f", *frame.pointed) : "nowhere");
  }
  top_ = ImGui::GetCursorScreenPos().y;
  for (std::size_t k = 0; k < kObservableCount; ++k) {
    draw_plot(in, frame, k, k + 1 == kObservableCount);
  }
  bottom_ = ImGui::GetCursorScreenPos().y;
  draw_note(in, frame);
  draw_menu(in, frame);
}

void PlotsPanel::follow_mouse(Frame& frame) const {
  const ImVec2 mouse = ImGui::GetMousePos();
  const bool over = mouse.x >= frame.left && mouse.x <= frame.left + frame.width &&
                    mouse.y >= top_ && mouse.y < bottom_;
  if (over && ImGui::IsWindowHovered()) frame.pointed = frame.axis().value(mouse.x);
}

void PlotsPanel::draw_choices(const PanelInput& in, const Frame& frame) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x, padding = ImGui::GetStyle().FramePadding.x;
  const float button = ImGui::CalcTextSize("CSV").x + 2 * padding;
  const float room = ImGui::GetContentRegionAvail().x - button - 2 * spacing;
  draw_spans("plots-span", "How much of the run the plots show", 0.42f * room, kSpans, span_, in);
  ImGui::SameLine();
  draw_spans("plots-smooth", "Over how long flows are averaged", 0.58f * room, kSmoothings,
             smoothing_, in);
  ImGui::SameLine();
  if (ImGui::Button("CSV")) ImGui::OpenPopup("plots-csv");
  in.events.widget("plots-csv");
  if (!ImGui::BeginPopup("plots-csv")) return;
  list_rows([&] { export_items(in, frame); });
  ImGui::EndPopup();
}

void PlotsPanel::draw_menu(const PanelInput& in, const Frame& frame) {
  if (frame.pointed && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    ImGui::OpenPopup("plots-menu");
  }
  if (!ImGui::BeginPopup("plots-menu")) return;
  list_rows([&] {
    for (std::size_t i = 0; i < kSpans.size(); ++i) {
      if (ImGui::MenuItem(kSpans[i].text, nullptr, i == span_)) span_ = i;
    }
    ImGui::Separator();
    export_items(in, frame);
  });
  ImGui::EndPopup();
}

void PlotsPanel::export_items(const PanelInput& in, const Frame& frame) {
  const StepRange steps{std::llround(frame.time.low / frame.dt) + 1,
                        std::llround(frame.time.high / frame.dt)};
  if (ImGui::MenuItem("Copy as CSV")) {
    ImGui::SetClipboardText(history_csv(in.state, steps).c_str());
    in.controls.message = "copied what the plots show";
  }
  in.events.widget("plots-copy");
  if (ImGui::MenuItem("Save as CSV")) in.controls.save_csv = steps;
  in.events.widget("plots-save");
}

void PlotsPanel::draw_plot(const PanelInput& in, const Frame& frame, std::size_t observable,
                           bool last) {
  const ObservableField& row = observables()[observable];
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float below = last ? plot_margin_below(in.fonts) : kGapLines * em;
  const float lines = paper_lines(row);
  const ImVec2 size{plot_margin_left() + frame.width, (kTitleLines + lines) * em + below};
  ImGui::Dummy(size);
  in.events.widget("plot-" + std::string(row.name));
  if (!ImGui::IsItemVisible()) return;

  const PlotColors colors = plot_colors();
  const double window = window_of(observable);
  std::vector<Reading> readings;
  if (frame.pointed) {
    const auto read = [&](const std::vector<CurvePoint>& curve, ImU32 color) {
      const auto value = value_at(curve, *frame.pointed);
      if (!value) return;
      const bool whole = std::abs(*value - std::round(*value)) < 1e-9;
      const int digits = row.digits == 0 && !whole ? 1 : row.digits;
      const double unit = std::pow(10, -digits);
      const double shown = unit * std::round(*value / unit) + 0.0;  // no "-0"
      readings.push_back({io::formatted("%.*f", digits, shown), color});
      if (is_temperature(row)) readings.back().text += " = " + celsius_text(*value);
    };
    read(observable_curve(frame.first, observable, window), colors.curve);
    read(observable_curve(frame.second, observable, window), colors.second);
    if (is_temperature(row) && frame.selected) {
      read(pup_curve(frame.first, *frame.selected), colors.selected);
    }
  }
  draw_title(in.fonts, row, corner, size.x, readings);

  const Area paper{{frame.left, corner.y + kTitleLines * em}, {frame.width, lines * em}};
  constexpr int kRounding = 16;  // steps of the range, so that it moves now and then only
  const double least = std::pow(10, -row.digits);
  Range range{row.low, row.high};
  for (const auto* entries : {&frame.first, &frame.second}) {
    widen_to(range, *entries, observable, frame.time, window);
  }
  const Plot plot(
      in.fonts, paper,
      {.x = frame.time, .y = rounded(range, kRounding, least), .x_labels = last, .y_least = least});
  draw_curves(plot, frame, observable, in.state.second.has_value());
  std::int64_t drawn = -1;
  for (const Timeline::Mark& mark : in.state.timeline.marks) {
    const double time = static_cast<double>(mark.step) * frame.dt;
    const double until = static_cast<double>(mark.until.value_or(mark.step)) * frame.dt;
    if (until < frame.time.low || time > frame.time.high) continue;
    if (mark.until) plot.stretch(time, until, colors.grid);
    const std::int64_t pixel = std::lround(plot.x().place(time));
    if (pixel != drawn) plot.upright(time, colors.mark, true);
    drawn = pixel;
  }
  if (in.state.second && in.state.diverged_at) {
    plot.upright(static_cast<double>(*in.state.diverged_at) * frame.dt, colors.second, true);
  }
  if (!in.state.history.empty() && in.state.history.last() > in.state.view().step) {
    plot.upright(frame.now, colors.now);
  }
  if (frame.pointed) plot.upright(*frame.pointed, colors.zero);
}

void PlotsPanel::draw_curves(const Plot& plot, const Frame& frame, std::size_t observable,
                             bool second) const {
  const PlotColors colors = plot_colors();
  const double window = window_of(observable);
  const auto draw = [&](const std::vector<CurvePoint>& curve, ImU32 color) {
    plot.curve(columns(curve, plot.x()), color);
  };
  const bool temperature = is_temperature(observables()[observable]);
  if (temperature) {
    plot.band(columns(tb_band(frame.first), plot.x()), colors.band);
    draw(temperature_curve(frame.first, &History::Sample::tp), colors.tp);
    draw(temperature_curve(frame.first, &History::Sample::ta), colors.ta);
  }
  if (window > 0) draw(observable_curve(frame.first, observable, 0), colors.raw);
  if (second) draw(observable_curve(frame.second, observable, window), colors.second);
  draw(observable_curve(frame.first, observable, window), colors.curve);
  if (!temperature || frame.first.empty()) return;
  if (frame.selected) draw(pup_curve(frame.first, *frame.selected), colors.selected);
  name_temperatures(plot, frame);
}

/// At the end of the lines of T_p and T_a, side by side, so that they never lie over each other.
void PlotsPanel::name_temperatures(const Plot& plot, const Frame& frame) {
  const PlotColors colors = plot_colors();
  const History::Sample& newest = *frame.first.back().sample;
  const double em =
      static_cast<double>(ImGui::GetFontSize() / frame.width) * (frame.time.high - frame.time.low);
  const double end = std::min(newest.time, frame.time.high) - em;
  const auto name = [&](double x, double value, ImU32 color, const char* text, bool above) {
    const float line = 0.55f * ImGui::GetFontSize();
    const float low = plot.y().from - plot.y().place(value);  // room below the line
    plot.text(x, value, color, text, above || low < 2 * line ? line : -line);
  };
  name(end, newest.tp, colors.tp, "T\u209a", newest.tp >= newest.ta);
  name(end - 2 * em, newest.ta, colors.ta, "T\u2090", newest.ta > newest.tp);
}

/// A line of fixed place below the plots: what is under the mouse, else what the axis means.
void PlotsPanel::draw_note(const PanelInput& in, const Frame& frame) const {
  std::string text = "time (s)";
  if (frame.mark) {
    text = io::formatted("%.2f s: ", static_cast<double>(frame.mark->step) * frame.dt) +
           frame.mark->text;
  } else if (frame.pointed) {
    text = io::formatted("at %.2f s, step %.0f", *frame.pointed, *frame.pointed / frame.dt);
  } else if (frame.first.size() > 1) {
    const int steps = frame.first[frame.first.size() / 2].sample->steps;
    if (steps > 1) text += io::formatted(", %d steps a point", steps);
  }
  small_rich_text(in.fonts, kFaint, text);
  if (!in.state.second) return;
  const float room = ImGui::GetContentRegionAvail().x;
  const float width = small_text_size(in.fonts, text + "second litter").x;
  if (width + 2 * ImGui::GetFontSize() < room) ImGui::SameLine(0, ImGui::GetFontSize());
  small_rich_text(in.fonts, plot_colors().second, "second litter");
}

}  // namespace pupflow::window
