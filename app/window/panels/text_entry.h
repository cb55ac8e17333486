// A field that holds a number as text until it is done.
#pragma once

#include <imgui.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace pupflow::window {

/// Whether the item just submitted, a slider, was asked for its field: by Ctrl + click, by a double
/// click, or by Enter.
bool asks_to_type();

/// Whether the left button has just gone down for the second time.
bool double_clicked();

/// Text fields of one panel, of which one at a time has the keyboard. They hand over text, not
/// numbers: whoever reads it can say what is wrong with it.
class TextEntry {
 public:
  /// Draws a field of that width, which holds `shown` while nobody types. Returns what was typed
  /// when it is done (Enter, Tab, a click elsewhere) and differs from what was there; Escape leaves
  /// what was there.
  std::optional<std::string> draw(const char* label, std::string_view shown, float width);

  /// Gives the keyboard to the field of that label, in the present ID scope, when it is drawn next.
  void focus(const char* label) { focus_ = ImGui::GetID(label); }

 private:
  using Text = std::array<char, 64>;

  Text text_{};  // of the field that has the keyboard
  std::string before_;
  ImGuiID active_ = 0, focus_ = 0;
};

}  // namespace pupflow::window
