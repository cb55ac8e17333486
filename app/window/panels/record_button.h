// Begins and ends a film.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws it into the current Dear ImGui window: while it films, with the seconds of the film so far.
void draw_record_button(float width, const PanelInput& in);

}  // namespace pupflow::window
