#include "app/window/panels/overlay_menu.h"

#include <algorithm>
#include <array>
#include <string>

#include "app/io/text.h"
#include "app/view/overlay.h"
#include "app/window/panels/choice.h"
#include "app/window/panels/list_rows.h"
#include "app/window/typed_number.h"

namespace pupflow::window {
namespace {

constexpr std::array<const char*, 3> kDrawDocs{"spheres around the points, by which pups touch",
                                               "a closed skin", "the skin, with the points in it"};
constexpr std::array<const char*, 3> kQualityDocs{
    "without shadows and soft edges", "with shadows and soft edges", "3 x 3 samples a pixel"};

void draw_box(const char* label, const std::string& name, bool& on, std::string_view doc,
              const PanelInput& in) {
  check_box(label, &on);
  in.events.widget(name);
  in.tips.show(doc);
}

/// A list of the values of an enumeration by their names.
template <class Value, std::size_t N>
void draw_values(const char* name, const char* doc, const std::array<std::string_view, N>& names,
                 const std::array<const char*, N>& docs, Value& value, const PanelInput& in) {
  const auto present = static_cast<std::size_t>(value);
  const std::string shown = std::string(name) + ": " + std::string(names[present]);
  draw_choice(name, shown, doc, in, [&](const auto& choice) {
    for (std::size_t i = 0; i < N; ++i) {
      if (choice(names[i], names[i], docs[i], i == present)) value = static_cast<Value>(i);
    }
  });
}

}  // namespace

int OverlayMenu::lines() {
  return static_cast<int>(view::overlays().size()) + 3;
}

void OverlayMenu::draw(const PanelInput& in) {
  pictures::Look& look = in.controls.look;
  for (const view::Overlay& overlay : view::overlays()) {
    const std::string name(overlay.name);
    bool on = look.overlays.has(name);
    draw_box(name.c_str(), "overlay-" + name, on, overlay.doc, in);
    look.overlays.set(name, on);
    if (on && name == "trails") draw_trail(in);
  }
  draw_box("caption", "caption", look.caption, "what is shown, in a line below it", in);
  draw_values("draw", "What pups are drawn as", view::kDrawNames, kDrawDocs, look.draw, in);
  const view::Quality before = look.quality;
  draw_values("quality", "How well they are drawn", view::kQualityNames, kQualityDocs, look.quality,
              in);
  if (look.quality != before) look.supersample = 0;  // as many samples as that quality has
}

void OverlayMenu::draw_trail(const PanelInput& in) {
  double& trail = in.controls.look.trail;
  // On the line of its box, so that nothing moves when it comes.
  ImGui::SameLine();
  const float unit = ImGui::CalcTextSize("s").x + ImGui::GetStyle().ItemSpacing.x;
  const float width = std::min(3 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x - unit);
  const auto typed = text_.draw("##trail", io::number_text(trail), width);
  in.events.widget("trail");
  in.tips.show("How long trails are, in seconds of the model");
  ImGui::SameLine();
  ImGui::TextUnformatted("s");
  if (!typed) return;
  const Typed read = read_typed("the length of trails", 0.01, pictures::kLongestTrail, *typed);
  if (const auto* seconds = std::get_if<double>(&read)) {
    trail = *seconds;
    in.controls.problem.clear();
  } else {
    in.controls.refuse("trail", std::get<std::string>(read));
  }
}

}  // namespace pupflow::window
