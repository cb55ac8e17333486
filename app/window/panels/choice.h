// A list of choices, of which one holds.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "app/window/panels/list_rows.h"
#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws a list called `name` (to tests too) that shows `present`, of that width. While it is
/// open `choices` says each entry by `choice(item, text, doc, chosen)`, which returns whether it
/// was picked. `doc` is the tip of the closed list.
template <class Choices>
void draw_choice(const char* name, std::string_view present, std::string_view doc,
                 const PanelInput& in, const Choices& choices, float width = -FLT_MIN) {
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(),
                                      std::string(present).c_str(), ImGuiComboFlags_HeightLargest);
  in.events.widget(name);
  if (!open) {
    in.tips.show(doc);
    return;
  }
  list_rows([&] {
    choices([&](std::string_view item, std::string_view text, std::string_view tip, bool chosen) {
      const std::string shown = std::string(text) + "##" + std::string(item);
      const bool picked = ImGui::Selectable(shown.c_str(), chosen);
      in.events.widget(std::string(name) + '-' + std::string(item));
      if (!tip.empty()) in.tips.show(tip);
      return picked;
    });
  });
  ImGui::EndCombo();
}

}  // namespace pupflow::window
