#include "app/window/panels/color_lists.h"

#include <array>
#include <string>

#include "app/view/color_scale.h"
#include "app/window/panels/choice.h"
#include "app/window/panels/color_ends.h"

namespace pupflow::window {
namespace {

constexpr std::array kEnds{view::Ends::automatic, view::Ends::field, view::Ends::around_tp};

const char* doc_of(view::Ends ends) {
  switch (ends) {
    case view::Ends::automatic:
      return "The middle 90 % of what is seen";
    case view::Ends::field:
      return "The field's own range";
    case view::Ends::around_tp:
      return "T_p in the middle";
    case view::Ends::typed:
      return "Typed or dragged";
  }
  return "";
}

}  // namespace

void draw_field_list(const PanelInput& in) {
  const LitterField& present = *in.controls.look.scale.field;
  draw_choice("color_by", present.label, present.doc, in, [&](const auto& choice) {
    for (const auto table : {pup_fields(), afferent_fields()}) {
      ImGui::TextDisabled(table.front().of_afferents ? "of each point" : "of each pup");
      for (const LitterField& field : table) {
        // By name: the field of the command line is in the executable's own table.
        const bool chosen = field.name == present.name;
        if (choice(field.name, field.label, field.doc, chosen) && !chosen) {
          in.controls.color_by(field);
        }
      }
    }
  });
}

void draw_scale_lists(const PanelInput& in) {
  view::ColorScale& scale = in.controls.look.scale;
  if (ends_apply(scale, view::Ends::automatic)) {
    const std::string shown = "ends: " + ends_label(scale, scale.ends);
    draw_choice("ends", shown, doc_of(scale.ends), in, [&](const auto& choice) {
      for (const view::Ends ends : kEnds) {
        if (!ends_apply(scale, ends)) continue;
        const bool chosen = ends == scale.ends;
        if (choice(view::name_of(ends), ends_label(scale, ends), doc_of(ends), chosen)) {
          choose_ends(scale, ends);
        }
      }
    });
  }
  if (scale.categorical()) return;
  const std::string shown = "map: " + std::string(scale.map_name);
  draw_choice("colormap", shown, "The colors from the lower end to the upper one", in,
              [&](const auto& choice) {
                for (const std::string_view name : view::colormap_names()) {
                  if (choice(name, name, "", name == scale.map_name)) scale.set_map(name);
                }
              });
}

}  // namespace pupflow::window
