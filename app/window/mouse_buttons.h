// Clicks that come faster than frames.
#pragma once

#include <imgui.h>

#include <array>
#include <deque>
#include <optional>

namespace pupflow::window {

/// What Dear ImGui itself does since 1.87: of each button a frame sees one change at most, so a click
/// between two frames is no less a click, and two of them are a double click. A change is seen with
/// the mouse where it was then.
class MouseButtons {
 public:
  /// The mouse is there from now on, in window coordinates.
  void moved(ImVec2 place) { place_ = place; }

  /// `button` went down or up, `time` in seconds. Buttons that Dear ImGui does not know are left out.
  void changed(int button, bool down, double time);

  /// Sets the buttons of the frame that begins, the place of the mouse where a button changes, and how
  /// long ago the first of two clicks may be.
  void apply(ImGuiIO& io);

  /// Another frame is needed.
  bool waiting() const { return !changes_.empty(); }

 private:
  struct Change {
    int button;
    bool down, doubles;
    std::optional<ImVec2> place;
  };

  std::deque<Change> changes_;
  std::optional<ImVec2> place_;  // none: it was never told
  std::array<bool, ImGuiMouseButton_COUNT> down_{};
  std::array<double, ImGuiMouseButton_COUNT> pressed_at_{-1, -1, -1, -1, -1};
};

}  // namespace pupflow::window
