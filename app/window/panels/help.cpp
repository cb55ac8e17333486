#include "app/window/panels/help.h"

#include <imgui.h>

#include <algorithm>

#include "app/window/imgui_compat.h"

namespace pupflow::window {
namespace {

constexpr float kMostKeys = 0.42f;  // of the width, for the column of keys

constexpr ImGuiWindowFlags kHelp =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

/// Calls `visit(heading, rows)` for each table.
template <class Visit>
void for_each_table(const Visit& visit) {
  visit("Keys", key_table());
  visit("Mouse", mouse_table());
}

struct Widths {
  float keys = 0, doc = 0;
};

/// The widths of the two columns where nothing has to wrap.
Widths unwrapped() {
  Widths widths;
  for_each_table([&](const char*, const auto& rows) {
    for (const auto& row : rows) {
      widths.keys = std::max(widths.keys, ImGui::CalcTextSize(row.text).x);
      widths.doc = std::max(widths.doc, ImGui::CalcTextSize(row.doc).x);
    }
  });
  return widths;
}

void heading(const char* text, const PanelInput& in) {
  push_font(in.fonts.title);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

template <class Rows>
void draw_rows(const char* id, const Rows& rows, float keys) {
  if (!ImGui::BeginTable(id, 2)) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keys);
  ImGui::TableSetupColumn("doc", ImGuiTableColumnFlags_WidthStretch);
  const auto cell = [](const char* text) {
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
  };
  for (const auto& row : rows) {
    cell(row.text);
    cell(row.doc);
  }
  ImGui::EndTable();
}

/// How high the tables are in columns of these widths.
float height_of_tables(const Widths& widths, const PanelInput& in) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float height = 0;
  for_each_table([&](const char*, const auto& rows) {
    height += pixel_size(*in.fonts.title) * font_scale() + 2 * style.ItemSpacing.y;
    for (const auto& row : rows) {
      const float keys = ImGui::CalcTextSize(row.text, nullptr, false, widths.keys).y;
      const float doc = ImGui::CalcTextSize(row.doc, nullptr, false, widths.doc).y;
      height += std::max(keys, doc) + 2 * style.CellPadding.y;
    }
  });
  return height;
}

}  // namespace

void draw_help(const PanelInput& in) {
  in.events.help(in.controls.help);
  if (!in.controls.help) return;
  const float em = ImGui::GetFontSize();
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float margins = 4 * style.CellPadding.x + style.ScrollbarSize + em;
  const ImVec2 room{window.x - em - 2 * style.WindowPadding.x,
                    window.y - em - 2 * style.WindowPadding.y};
  Widths widths = unwrapped();
  const float width = std::min(widths.keys + widths.doc + margins, room.x);
  widths.keys = std::min(widths.keys, kMostKeys * width);
  widths.doc = width - widths.keys - margins;
  const float close = ImGui::GetFrameHeight() + style.ItemSpacing.y;
  const float height = std::min(height_of_tables(widths, in), room.y - close);

  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {width + 2 * style.WindowPadding.x, height + close + 2 * style.WindowPadding.y});
  ImGui::Begin("help", nullptr, kHelp);
  ImGui::BeginChild("rows", {0, height});
  for_each_table([&](const char* title, const auto& rows) {
    heading(title, in);
    draw_rows(title, rows, widths.keys);
  });
  ImGui::EndChild();
  if (ImGui::Button("Close")) in.controls.help = false;
  in.events.widget("close_help");
  ImGui::End();
}

}  // namespace pupflow::window
