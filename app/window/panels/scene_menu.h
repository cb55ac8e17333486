// The shipped scenes, with a picture and a sentence each.
#pragma once

#include <memory>

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// A submenu. A context must be current whenever a function here runs, the destructor included.
class SceneMenu {
 public:
  SceneMenu();
  ~SceneMenu();
  SceneMenu(const SceneMenu&) = delete;
  SceneMenu& operator=(const SceneMenu&) = delete;

  /// Draws it into the current menu. The scene that was picked is then `controls.open`.
  void draw(const PanelInput& in);

 private:
  struct Pictures;
  std::unique_ptr<Pictures> pictures_;  // made when it is opened first
};

}  // namespace pupflow::window
