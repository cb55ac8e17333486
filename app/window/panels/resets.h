// Many parameters at once: presets of T_a, back to the scene, back to the paper.
#pragma once

#include "app/window/panels/panel.h"
#include "pupflow/parameters.h"

namespace pupflow::window {

/// The symbol of a parameter, or its name where it has none.
std::string label_of(const Parameter& parameter);

/// What differs between two parameter sets, as people read it: "T_a 0.2 -> 0.4, N 20 -> 12" with
/// a real arrow. At most `most` of them are named.
std::string difference_text(const Params& from, const Params& to, int most = 4);

/// The value of `parameter` in the cold, critical and warm scenes, as a table row of buttons.
void draw_presets(const Parameter& parameter, const PanelInput& in);

/// Two buttons. The tooltip of each says what it would change.
void draw_resets(const PanelInput& in);

}  // namespace pupflow::window
