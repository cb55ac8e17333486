#include "app/window/panels/numbers_panel.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace pupflow::window {
namespace {

constexpr float kPlotLines = 3.2f;  // height of a plot, in lines of text

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string text_of(std::string_view words) {
  return std::string(words);
}

void tip(const Field& field, const PanelInput& in) {
  in.tips.show(text_of(field.doc) + '\n' + text_of(field.equation));
}

void draw_numbers(const PanelInput& in) {
  if (!ImGui::BeginTable("numbers", 3)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 4 * em);
  ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, 2.6f * em);
  for (const ObservableField& row : observables()) {
    ImGui::TableNextColumn();
    rich_text(in.fonts, kInk, text_of(row.label).c_str());
    tip(row, in);
    ImGui::TableNextColumn();
    const std::string text =
        in.state.observables ? number(*in.state.observables.*row.value, row.digits) : "\u2013";
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room, 0.0f));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text_of(row.unit).c_str());
  }
  ImGui::EndTable();
}

struct Range {
  float low, high;
};

/// What the plot of one observable spans: its least range, widened to all there is to show.
Range span_of(const History& history, std::size_t observable) {
  const ObservableField& row = observables()[observable];
  Range range{static_cast<float>(row.low), static_cast<float>(row.high)};
  for (int i = 0; i < history.size(); ++i) {
    range.low = std::min(range.low, history.value(observable, i));
    range.high = std::max(range.high, history.value(observable, i));
  }
  return range;
}

void small_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, const char* text) {
  list.AddText(fonts.small, fonts.small->FontSize * ImGui::GetIO().FontGlobalScale, place, kFaint,
               text);
}

/// The curve fills the plot from the right; a full history reaches its left edge.
void draw_curve(ImDrawList& list, const History& history, std::size_t observable, Range range,
                ImVec2 low, ImVec2 size) {
  const float per_sample = size.x / (History::kSamples - 1);
  const float width = 0.1f * ImGui::GetFontSize();
  const float top = low.y + 2 * width, height = size.y - 4 * width;
  const auto place = [&](int i) {
    const auto from_right = static_cast<float>(history.size() - 1 - i);
    const float share = (history.value(observable, i) - range.low) / (range.high - range.low);
    return ImVec2{low.x + size.x - from_right * per_sample, top + height * (1 - share)};
  };
  // Single lines: the joints of a polyline would shoot out where the curve jumps.
  for (int i = 1; i < history.size(); ++i) list.AddLine(place(i - 1), place(i), kAccent, width);
}

void draw_plot(const PanelInput& in, std::size_t observable) {
  const ObservableField& row = observables()[observable];
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, (1.2f + kPlotLines) * em};
  draw_rich_text(list, in.fonts, corner, kInk, text_of(row.label).c_str());
  const float labels = 2.7f * em, top = 1.35f * em;
  const ImVec2 low{corner.x + labels, corner.y + top}, room{size.x - labels, size.y - top};
  const Range range = span_of(in.state.history, observable);
  list.AddRectFilled(low, {low.x + room.x, low.y + room.y}, IM_COL32_WHITE);
  list.AddRect(low, {low.x + room.x, low.y + room.y}, kLine);
  char text[32];
  const auto label = [&](float value, float y) {
    std::snprintf(text, sizeof text, "%.3g", static_cast<double>(value));
    const float width =
        in.fonts.small
            ->CalcTextSizeA(in.fonts.small->FontSize * ImGui::GetIO().FontGlobalScale, FLT_MAX, 0,
                            text)
            .x;
    small_text(list, in.fonts, {low.x - width - 0.3f * em, y}, text);
  };
  label(range.high, low.y - 0.1f * em);
  label(range.low, low.y + room.y - 0.85f * em);
  draw_curve(list, in.state.history, observable, range, low, room);
  ImGui::Dummy({size.x, size.y + 0.2f * em});
  tip(row, in);
}

void draw_plots(const PanelInput& in) {
  for (std::size_t k = 0; k < kObservableCount; ++k) draw_plot(in, k);
  constexpr int kSteps = History::kSamples * History::kStepsPerSample;
  ImGui::PushFont(in.fonts.small);
  ImGui::TextDisabled("the last %d steps (%.3g s), means over %d", kSteps,
                      kSteps * in.state.view().params.dt, History::kStepsPerSample);
  ImGui::PopFont();
}

}  // namespace

bool draw_numbers_panel(const PanelInput& in) {
  const bool numbers = ImGui::CollapsingHeader("numbers", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("numbers");
  if (numbers) draw_numbers(in);
  const bool plots = ImGui::CollapsingHeader("plots", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("plots");
  if (plots) draw_plots(in);
  return numbers || plots;
}

}  // namespace pupflow::window
