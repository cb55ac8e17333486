#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "app/view/font.h"

namespace pupflow::window {
namespace {

constexpr float kTextSize = 14, kSmallSize = 10.5f, kTitleSize = 17;

// What the parameter table and the panels use: Latin, Greek, dashes and dots, sub- and
// superscripts, arrows, minus and relations, the triangle of T_p.
constexpr std::array<ImWchar, 17> kRanges{0x0020, 0x00ff, 0x0370, 0x03ff, 0x2010, 0x2026,
                                          0x2070, 0x209c, 0x2190, 0x21ff, 0x2200, 0x2265,
                                          0x25a0, 0x25ff, 0x2713, 0x2713, 0};

ImFont* add_font(float size) {
  const std::span<const std::byte> file = view::font_file();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  // The atlas only reads what it does not own.
  void* data = const_cast<std::byte*>(file.data());
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(file.size()), size,
                                                    &config, kRanges.data());
}

ImVec4 color(ImU32 packed, float alpha = 1) {
  ImVec4 value = ImGui::ColorConvertU32ToFloat4(packed);
  value.w = alpha;
  return value;
}

void set_colors(ImGuiStyle& style) {
  ImGui::StyleColorsLight(&style);
  ImVec4* const colors = style.Colors;
  colors[ImGuiCol_Text] = color(kInk);
  colors[ImGuiCol_TextDisabled] = color(kFaint);
  colors[ImGuiCol_WindowBg] = color(IM_COL32(246, 247, 249, 255));
  colors[ImGuiCol_MenuBarBg] = color(IM_COL32(233, 236, 240, 255));
  colors[ImGuiCol_PopupBg] = color(IM_COL32(255, 255, 255, 255));
  colors[ImGuiCol_Border] = color(kLine);
  colors[ImGuiCol_FrameBg] = color(IM_COL32(226, 230, 235, 255));
  colors[ImGuiCol_FrameBgHovered] = color(IM_COL32(214, 224, 231, 255));
  colors[ImGuiCol_FrameBgActive] = color(IM_COL32(202, 219, 228, 255));
  colors[ImGuiCol_SliderGrab] = color(IM_COL32(141, 190, 209, 255));  // text runs across it
  colors[ImGuiCol_SliderGrabActive] = color(IM_COL32(104, 170, 195, 255));
  colors[ImGuiCol_CheckMark] = color(kAccent);
  colors[ImGuiCol_Button] = color(IM_COL32(221, 227, 232, 255));
  colors[ImGuiCol_ButtonHovered] = color(IM_COL32(201, 218, 227, 255));
  colors[ImGuiCol_ButtonActive] = color(IM_COL32(176, 203, 217, 255));
  colors[ImGuiCol_Header] = color(IM_COL32(233, 236, 240, 255));
  colors[ImGuiCol_HeaderHovered] = color(IM_COL32(219, 228, 234, 255));
  colors[ImGuiCol_HeaderActive] = color(IM_COL32(202, 219, 228, 255));
  colors[ImGuiCol_Separator] = color(kLine);
  colors[ImGuiCol_TextSelectedBg] = color(kAccent, 0.3f);
}

}  // namespace

Fonts load_fonts(float scale, float density) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const float pixels = scale * density;
  Fonts fonts;
  fonts.text = add_font(kTextSize * pixels);
  fonts.small = add_font(kSmallSize * pixels);
  fonts.title = add_font(kTitleSize * pixels);
  io.FontGlobalScale = 1 / density;
  return fonts;
}

void apply_theme(float scale) {
  ImGuiStyle style;
  set_colors(style);
  style.WindowPadding = {12, 12};
  style.FramePadding = {7, 3};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 2};
  style.FrameRounding = 4;
  style.GrabRounding = 3;
  style.PopupRounding = 5;
  style.WindowRounding = 6;
  style.ScrollbarSize = 11;
  style.ScrollbarRounding = 6;
  style.GrabMinSize = 11;
  style.WindowBorderSize = 1;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

float draw_rich_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, ImU32 color,
                     std::string_view text) {
  const float ratio = ImGui::GetIO().FontGlobalScale;
  const float drop = 0.32f * fonts.text->FontSize * ratio;
  float x = place.x;
  const auto draw = [&](ImFont* font, float y, std::string_view part) {
    const float size = font->FontSize * ratio;
    list.AddText(font, size, {x, y}, color, part.data(), part.data() + part.size());
    x += font->CalcTextSizeA(size, FLT_MAX, 0, part.data(), part.data() + part.size()).x;
  };
  while (!text.empty()) {
    const std::size_t mark = std::min(text.find('_'), text.size());
    draw(fonts.text, place.y, text.substr(0, mark));
    text.remove_prefix(mark);
    if (text.empty()) break;
    text.remove_prefix(1);
    const auto end = std::find_if_not(text.begin(), text.end(),
                                      [](unsigned char c) { return std::isalnum(c) != 0; });
    const auto length = static_cast<std::size_t>(end - text.begin());
    draw(fonts.small, place.y + drop, text.substr(0, length));
    text.remove_prefix(length);
  }
  return x - place.x;
}

void rich_text(const Fonts& fonts, ImU32 color, std::string_view text) {
  ImGui::AlignTextToFramePadding();
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const float offset = ImGui::GetStyle().FramePadding.y;
  const float width =
      draw_rich_text(*ImGui::GetWindowDrawList(), fonts, {place.x, place.y + offset}, color, text);
  ImGui::Dummy({width, ImGui::GetFrameHeight()});
}

}  // namespace pupflow::window
