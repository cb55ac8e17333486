#include "app/window/panels/record_button.h"

#include "app/io/text.h"

namespace pupflow::window {

void draw_record_button(float width, const PanelInput& in) {
  const std::optional<double>& filmed = in.controls.filmed;
  const std::string label =
      (filmed ? io::formatted("\u25a0 %.1f s", *filmed) : std::string("Film")) + "###record";
  if (filmed) ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  if (ImGui::Button(label.c_str(), {width, 0})) in.controls.actions.push_back(Action::record);
  if (filmed) ImGui::PopStyleColor();
  in.events.widget("record");
  in.tips.show("Begin or end a film, an MP4 file (V)");
}

}  // namespace pupflow::window
