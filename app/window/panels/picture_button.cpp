#include "app/window/panels/picture_button.h"

#include <imgui.h>

#include <variant>

#include "app/window/panels/list_rows.h"

namespace pupflow::window {
namespace {

constexpr const char* kPopup = "picture-sizes";
constexpr float kListWidth = 2;  // em, of the button for the list
constexpr float kField = 8;      // em

}  // namespace

void PictureButton::draw(float width, const PanelInput& in) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
  if (ImGui::Button("Picture", {width - kListWidth * em - gap, 0})) {
    in.controls.actions.push_back(Action::screenshot);
  }
  in.events.widget("screenshot");
  in.tips.show("Save a picture with all parameters in it, " +
               size_text(in.controls.picture_size.of(in.controls.seen_size)) + " pixels (S)");
  ImGui::SameLine(0, gap);
  if (ImGui::Button("\u25be##sizes", {kListWidth * em, 0})) {
    problem_.clear();
    ImGui::OpenPopup(kPopup);
  }
  in.events.widget("picture-sizes");
  in.tips.show("How large pictures and films are");
  if (!ImGui::BeginPopup(kPopup)) return;
  list_rows([&] { draw_sizes(in); });
  ImGui::EndPopup();
}

void PictureButton::draw_sizes(const PanelInput& in) {
  ImGui::TextDisabled("Size of pictures and films");
  PictureSize& chosen = in.controls.picture_size;
  for (const OfferedSize& offered : offered_sizes()) {
    const std::string pixels = size_text(offered.size.of(in.controls.seen_size));
    if (ImGui::MenuItem(std::string(offered.text).c_str(), pixels.c_str(),
                        offered.size == chosen)) {
      chosen = offered.size;
    }
    in.events.widget("picture-" + std::string(offered.name));
  }
  draw_typed(in);
  if (in.state.second) ImGui::TextDisabled("Both litters are in it.");
}

void PictureButton::draw_typed(const PanelInput& in) {
  PictureSize& chosen = in.controls.picture_size;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Pixels");
  ImGui::SameLine();
  const auto typed = entry_.draw("##pixels", size_text(chosen.of(in.controls.seen_size)),
                                 kField * ImGui::GetFontSize());
  in.events.widget("picture-pixels");
  if (typed) {
    const auto read = read_size(*typed);
    const PixelSize* size = std::get_if<PixelSize>(&read);
    problem_ = size == nullptr ? std::get<std::string>(read) : std::string();
    if (size != nullptr) chosen = {.pixels = *size};
  }
  problem_line(problem_);
}

}  // namespace pupflow::window
