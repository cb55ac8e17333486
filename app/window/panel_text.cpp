#include "app/window/panel_text.h"

#include <algorithm>
#include <cctype>

#include "app/window/imgui_compat.h"

namespace pupflow::window {

namespace {

/// Calls `run(font, is_subscript, part)` for each run of rich text.
template <class Run>
void for_each_run(const Fonts& fonts, std::string_view text, const Run& run) {
  while (!text.empty()) {
    const std::size_t mark = std::min(text.find('_'), text.size());
    run(*fonts.text, false, text.substr(0, mark));
    text.remove_prefix(mark);
    if (text.empty()) break;
    text.remove_prefix(1);
    const auto end = std::find_if_not(text.begin(), text.end(),
                                      [](unsigned char c) { return std::isalnum(c) != 0; });
    const auto length = static_cast<std::size_t>(end - text.begin());
    run(*fonts.small, true, text.substr(0, length));
    text.remove_prefix(length);
  }
}

float width_of_run(ImFont& font, std::string_view part) {
  const float size = pixel_size(font) * font_scale();
  return font.CalcTextSizeA(size, FLT_MAX, 0, part.data(), part.data() + part.size()).x;
}

}  // namespace

float draw_rich_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, ImU32 color,
                     std::string_view text) {
  const float drop = 0.32f * pixel_size(*fonts.text) * font_scale();
  float x = place.x;
  for_each_run(fonts, text, [&](ImFont& font, bool subscript, std::string_view part) {
    list.AddText(&font, pixel_size(font) * font_scale(), {x, place.y + (subscript ? drop : 0)},
                 color, part.data(), part.data() + part.size());
    x += width_of_run(font, part);
  });
  return x - place.x;
}

float rich_text_width(const Fonts& fonts, std::string_view text) {
  float width = 0;
  for_each_run(fonts, text, [&](ImFont& font, bool, std::string_view part) {
    width += width_of_run(font, part);
  });
  return width;
}

void rich_text(const Fonts& fonts, ImU32 color, std::string_view text) {
  ImGui::AlignTextToFramePadding();
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float offset = ImGui::GetStyle().FramePadding.y;
  const float width =
      draw_rich_text(*ImGui::GetWindowDrawList(), fonts, {place.x, place.y + offset}, color, text);
  ImGui::Dummy({width, ImGui::GetFrameHeight()});
}

ImVec2 small_text_size(const Fonts& fonts, const std::string& text) {
  push_font(fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::PopFont();
  return size;
}

void small_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, ImU32 color,
                const std::string& text) {
  push_font(fonts.small);
  list.AddText(place, color, text.c_str());
  ImGui::PopFont();
}

void small_rich_text(const Fonts& fonts, ImU32 color, const std::string& text) {
  Fonts small = fonts;
  small.text = fonts.small;
  const ImVec2 size = small_text_size(fonts, text);
  draw_rich_text(*ImGui::GetWindowDrawList(), small, ImGui::GetCursorScreenPos(), color, text);
  ImGui::Dummy({size.x, 1.3f * size.y});
}

void colored_text(ImU32 color, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void right_text(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room, 0.0f));
  ImGui::TextUnformatted(text.c_str());
}

void problem_line(const std::string& text) {
  colored_text(kBad, text.empty() ? " " : text);
}

}  // namespace pupflow::window
