// The menus along the top of the window.
#pragma once

#include "app/window/panels/overlay_menu.h"
#include "app/window/panels/panel.h"
#include "app/window/panels/scene_menu.h"

namespace pupflow::window {

/// Submits the main menu bar. Each entry asks for an action of the key table, so that what a menu
/// does a key does too. `overlays` is a menu of its own below View, and
/// `scenes` one below Scene.
void draw_menu(const PanelInput& in, OverlayMenu& overlays, SceneMenu& scenes);

}  // namespace pupflow::window
