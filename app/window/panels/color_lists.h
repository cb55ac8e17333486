// The lists of the colors: which field they show, their ends, the color map.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

void draw_field_list(const PanelInput& in);

/// Of the ends and the map, those that the field has.
void draw_scale_lists(const PanelInput& in);

}  // namespace pupflow::window
