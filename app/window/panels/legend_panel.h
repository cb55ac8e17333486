// The strip beside the arena: which field the colors show, their bar with ends that can be dragged
// and typed, what is drawn over the litter.
#pragma once

#include <optional>

#include "app/window/panels/area.h"
#include "app/window/panels/color_ends.h"
#include "app/window/panels/legend_plan.h"
#include "app/window/panels/overlay_menu.h"
#include "app/window/panels/panel.h"
#include "app/window/panels/text_entry.h"

namespace pupflow::window {

class LegendPanel {
 public:
  /// Draws it; `fitted` is the look's scale as the arena shows it. Without panels, only the bar.
  void draw(const Area& strip, const view::ColorScale& fitted, const PanelInput& in);

 private:
  void draw_bar(float height, const view::ColorScale& fitted, bool ends, const PanelInput& in);
  void draw_end(ScaleEnd end, const view::ColorScale& fitted, const PanelInput& in);
  void draw_grip(ScaleEnd end, const Area& bar, const view::ColorScale& fitted,
                 const PanelInput& in);
  void draw_section(const LegendPlan& plan, const PanelInput& in);

  TextEntry text_;
  OverlayMenu overlays_;
  std::optional<EndDrag> drag_;
};

}  // namespace pupflow::window
