// The names that changed between Dear ImGui 1.86 and 1.92, once. Everybody else uses these.
#pragma once

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cstdint>

namespace pupflow::window {

// Since 1.92 a font has no size of its own: sizes are given where text is drawn, and the renderer
// makes glyphs as they are needed. The sizes that fonts were added with are still those to use.
#if IMGUI_VERSION_NUM >= 19200

inline float pixel_size(const ImFont& font) {
  return font.LegacySize;
}
inline float ascent(ImFont& font) {
  return font.GetFontBaked(font.LegacySize)->Ascent;
}
inline void push_font(ImFont* font) {
  ImGui::PushFont(font, font->LegacySize);
}
inline float font_scale() {
  return ImGui::GetStyle().FontScaleMain;
}
inline void set_font_scale(float scale) {
  ImGui::GetStyle().FontScaleMain = scale;
}
inline void remake_font_texture() {}

#else

/// The size that the font was added with, in pixels of its texture, and how far it rises above the
/// baseline.
inline float pixel_size(const ImFont& font) {
  return font.FontSize;
}
inline float ascent(const ImFont& font) {
  return font.Ascent;
}

/// ImGui::PopFont ends it.
inline void push_font(ImFont* font) {
  ImGui::PushFont(font);
}

/// Factor by which all fonts are drawn smaller or larger than their pixels.
inline float font_scale() {
  return ImGui::GetIO().FontGlobalScale;
}
inline void set_font_scale(float scale) {
  ImGui::GetIO().FontGlobalScale = scale;
}

/// After other fonts took the place of those that were drawn with.
inline void remake_font_texture() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

#endif

// Renamed in 1.91: the old names go.
#if IMGUI_VERSION_NUM >= 19140
constexpr auto kCursorColor = ImGuiCol_NavCursor;
#else
constexpr auto kCursorColor = ImGuiCol_NavHighlight;
#endif
#if IMGUI_VERSION_NUM >= 19100
constexpr auto kKeepsPopups = ImGuiSelectableFlags_NoAutoClosePopups;
#else
constexpr auto kKeepsPopups = ImGuiSelectableFlags_DontClosePopups;
#endif

/// An OpenGL texture as images take it.
inline ImTextureID texture_id(unsigned texture) {
#if IMGUI_VERSION_NUM >= 19140
  return static_cast<ImTextureID>(texture);
#else
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
#endif
}

/// Shows which widget keys move from and press.
inline void show_key_cursor() {
#if IMGUI_VERSION_NUM >= 19140
  ImGui::SetNavCursorVisible(true);
#else
  GImGui->NavDisableHighlight = false;
#endif
}

/// Since 1.87 a frame sees one change of a mouse button at most.
constexpr bool kQueuesClicks = IMGUI_VERSION_NUM >= 18700;

/// Whether a key went down, or repeats. Before 1.87 keys of Dear ImGui were places in a table.
inline bool key_pressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(key);
#else
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

}  // namespace pupflow::window
