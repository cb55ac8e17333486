// Working the panels by keyboard alone. Dear ImGui's own navigation moves between widgets; it has
// the keyboard only while this is switched on, so that otherwise Space plays and arrows step.
#pragma once

#include <span>

namespace pupflow::window {

/// Has keys work the panels from now on, those of the next of `panels` (names of Dear ImGui
/// windows) after the one that has them.
void work_next_panel(std::span<const char* const> panels);

/// Gives the keys back to the key table.
void leave_panels();

bool keys_work_panels();

/// Whether a widget or list gets this key (GLFW's code), and the key table does not: arrows, Space,
/// Enter and the like while keys work the panels, and Esc while a widget or list is held open by
/// them.
bool panels_take(int key);

/// Closes the list, menu or dialog in front. Returns false when none is open.
bool close_front_popup();

}  // namespace pupflow::window
