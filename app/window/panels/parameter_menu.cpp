#include "app/window/panels/parameter_menu.h"

#include <cmath>

#include "app/window/panels/list_rows.h"
#include "app/window/session/parameter_text.h"
#include "app/window/typed_number.h"

namespace pupflow::window {
namespace {

constexpr const char* kId = "menu";
constexpr double kLongestRamp = 1e6;  // model seconds

void set_to(const char* label, const char* name, double value, const Parameter& parameter,
            const PanelInput& in) {
  const std::string text = format_value(parameter, value);
  const bool differs = value != parameter.get(in.controls.params);
  if (ImGui::MenuItem(label, text.c_str(), !differs, differs)) {
    in.controls.propose(parameter, value);
  }
  in.events.widget(std::string(parameter.name) + '-' + name);
}

bool can_ramp(const Parameter& parameter) {
  return parameter.kind == Parameter::Kind::real &&
         parameter.effect == Parameter::Effect::next_step;
}

}  // namespace

void ParameterMenu::open(const Parameter& parameter, const PanelInput& in) {
  to_ = format_value(parameter, parameter.get(in.controls.scene));
  problem_.clear();
  ImGui::OpenPopup(kId);
}

bool ParameterMenu::draw(const Parameter& parameter, const PanelInput& in) {
  if (!ImGui::BeginPopup(kId)) return false;
  rich_text(in.fonts, kAccent, titled(parameter.symbol, parameter.title));
  ImGui::Separator();
  bool type = false;
  list_rows([&] {
    set_to("Default", "default", parameter.default_value(), parameter, in);
    set_to("The scene's value", "scene", parameter.get(in.controls.scene), parameter, in);
    if (parameter.kind == Parameter::Kind::choice) return;
    type = ImGui::MenuItem("Type a value", "Double click");
    in.events.widget(std::string(parameter.name) + "-type");
  });
  if (can_ramp(parameter)) draw_ramp(parameter, in);
  ImGui::EndPopup();
  return type;
}

void ParameterMenu::draw_ramp(const Parameter& parameter, const PanelInput& in) {
  const float width = 5 * ImGui::GetFontSize();
  const std::string name = std::string(parameter.name) + "-ramp-";
  const auto field = [&](const char* label, const char* what, std::string& text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine();
    if (auto typed = entry_.draw((std::string("##") + what).c_str(), text, width)) {
      text = std::move(*typed);
      problem_.clear();
    }
    in.events.widget(name + what);
    ImGui::SameLine();
  };
  ImGui::Separator();
  const std::string now = format_value(parameter, in.controls.params);
  field(("Ramp from " + now + " to").c_str(), "to", to_);
  field("in", "seconds", seconds_);
  ImGui::TextUnformatted("s of model time");
  check_box("and back in as many", &back_);
  in.events.widget(name + "back");
  if (ImGui::Button("Start the ramp")) start_ramp(parameter, in);
  in.events.widget(name + "start");
  problem_line(problem_);
}

void ParameterMenu::start_ramp(const Parameter& parameter, const PanelInput& in) {
  const double dt = in.state.view().params.dt;
  const Typed to = read_typed(parameter, to_);
  const Typed seconds = read_typed("seconds", dt, kLongestRamp, seconds_);
  for (const Typed* typed : {&to, &seconds}) {
    if (const std::string* reason = std::get_if<std::string>(typed)) {
      problem_ = *reason;
      return;
    }
  }
  in.controls.commands.push_back(RampTo{static_cast<std::size_t>(&parameter - parameters().data()),
                                        std::get<double>(to),
                                        std::llround(std::get<double>(seconds) / dt), back_});
  ImGui::CloseCurrentPopup();
}

}  // namespace pupflow::window
