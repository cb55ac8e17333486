#include "app/window/theme.h"

#include <array>
#include <utility>

#include "app/view/font.h"
#include "app/window/imgui_compat.h"

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

constexpr ImU32 rgb(int red, int green, int blue) {
  return IM_COL32(red, green, blue, 255);
}

constexpr Palette kLight{.ink = rgb(38, 42, 48),
                         .faint = rgb(88, 95, 104),
                         .accent = rgb(16, 92, 121),
                         .bad = rgb(168, 32, 32),
                         .paper_ink = rgb(38, 42, 48),
                         .paper_faint = rgb(88, 95, 104),
                         .paper = rgb(255, 255, 255),
                         .panel = rgb(246, 247, 249),
                         .menu = rgb(233, 236, 240),
                         .popup = rgb(255, 255, 255),
                         .bad_panel = rgb(253, 236, 234),
                         .field = rgb(226, 230, 235),
                         .field_hovered = rgb(217, 226, 232),
                         .field_active = rgb(208, 222, 230),
                         .button = rgb(223, 228, 233),
                         .button_hovered = rgb(208, 222, 230),
                         .button_active = rgb(204, 220, 228),
                         .header = rgb(233, 236, 240),
                         .header_hovered = rgb(219, 228, 234),
                         .header_active = rgb(208, 222, 230),
                         .line = rgb(208, 213, 219),
                         .grab = rgb(141, 190, 209),
                         .grab_active = rgb(104, 170, 195),
                         .second = rgb(182, 74, 8),
                         .selected = rgb(150, 40, 130),
                         .tp = rgb(96, 100, 106),
                         .ta = rgb(72, 92, 160),
                         .reference = rgb(120, 124, 130),
                         .pull = rgb(190, 110, 20)};

constexpr Palette kDark{.ink = rgb(225, 229, 234),
                        .faint = rgb(166, 174, 184),
                        .accent = rgb(122, 200, 228),
                        .bad = rgb(255, 150, 142),
                        .paper_ink = kLight.paper_ink,
                        .paper_faint = kLight.paper_faint,
                        .paper = kLight.paper,
                        .panel = rgb(30, 33, 37),
                        .menu = rgb(38, 42, 47),
                        .popup = rgb(38, 42, 47),
                        .bad_panel = rgb(60, 28, 28),
                        .field = rgb(48, 53, 60),
                        .field_hovered = rgb(54, 63, 71),
                        .field_active = rgb(52, 67, 77),
                        .button = rgb(50, 56, 63),
                        .button_hovered = rgb(54, 67, 76),
                        .button_active = rgb(40, 66, 78),
                        .header = rgb(40, 45, 51),
                        .header_hovered = rgb(50, 60, 68),
                        .header_active = rgb(52, 67, 77),
                        .line = rgb(70, 77, 86),
                        .grab = rgb(58, 108, 130),
                        .grab_active = rgb(66, 132, 158),
                        .second = rgb(240, 150, 84),
                        .selected = rgb(224, 140, 212),
                        .tp = rgb(176, 182, 190),
                        .ta = rgb(146, 168, 232),
                        .reference = rgb(150, 156, 164),
                        .pull = rgb(224, 160, 84)};

const Palette* in_use = &kLight;  // of the only window

ImVec4 opacity(ImU32 packed, float alpha) {
  ImVec4 value = ImGui::ColorConvertU32ToFloat4(packed);
  value.w = alpha;
  return value;
}

/// Colors without a place of their own in Palette are those of Dear ImGui.
void set_colors(Theme theme, ImGuiStyle& style) {
  if (theme == Theme::light) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
  }
  const Palette& of = palette();
  const std::pair<ImGuiCol, ImU32> places[] = {{ImGuiCol_Text, of.ink},
                                               {ImGuiCol_TextDisabled, of.faint},
                                               {ImGuiCol_WindowBg, of.panel},
                                               {ImGuiCol_MenuBarBg, of.menu},
                                               {ImGuiCol_PopupBg, of.popup},
                                               {ImGuiCol_TitleBg, of.menu},
                                               {ImGuiCol_TitleBgActive, of.menu},
                                               {ImGuiCol_Border, of.line},
                                               {ImGuiCol_FrameBg, of.field},
                                               {ImGuiCol_FrameBgHovered, of.field_hovered},
                                               {ImGuiCol_FrameBgActive, of.field_active},
                                               {ImGuiCol_SliderGrab, of.grab},
                                               {ImGuiCol_SliderGrabActive, of.grab_active},
                                               {ImGuiCol_CheckMark, of.accent},
                                               {ImGuiCol_Button, of.button},
                                               {ImGuiCol_ButtonHovered, of.button_hovered},
                                               {ImGuiCol_ButtonActive, of.button_active},
                                               {ImGuiCol_Header, of.header},
                                               {ImGuiCol_HeaderHovered, of.header_hovered},
                                               {ImGuiCol_HeaderActive, of.header_active},
                                               {ImGuiCol_Separator, of.line},
                                               {kCursorColor, of.accent}};
  for (const auto& [place, packed] : places) style.Colors[place] = opacity(packed, 1);
  style.Colors[ImGuiCol_TextSelectedBg] = opacity(of.accent, 0.3f);
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
  set_font_scale(1 / density);
  return fonts;
}

const Palette& palette_of(Theme theme) {
  return theme == Theme::light ? kLight : kDark;
}

const Palette& palette() {
  return *in_use;
}

void apply_theme(Theme theme, float scale) {
  in_use = &palette_of(theme);
  ImGuiStyle style;
  set_colors(theme, style);
  style.WindowPadding = {12, 12};
  style.FramePadding = {8, 5};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 1};
  style.FrameRounding = 4;
  style.GrabRounding = 3;
  style.PopupRounding = 5;
  style.WindowRounding = 6;
  style.ScrollbarSize = 12;
  style.ScrollbarRounding = 6;
  style.GrabMinSize = 11;
  style.WindowBorderSize = 1;
  style.ScaleAllSizes(scale);
  const float fonts = font_scale();  // in later versions part of the style
  ImGui::GetStyle() = style;
  set_font_scale(fonts);
}

ImU32 faded(ImU32 color, float alpha) {
  return ImGui::ColorConvertFloat4ToU32(opacity(color, alpha));
}

}  // namespace pupflow::window
