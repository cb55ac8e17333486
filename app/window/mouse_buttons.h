// Clicks that come faster than frames.
#pragma once

#include <imgui.h>

#include <array>
#include <deque>

namespace pupflow::window {

/// What Dear ImGui itself does since 1.87: of each button a frame sees one change at most, so a click
/// between two frames is no less a click, and two of them are a double click.
class MouseButtons {
 public:
  /// `button` went down or up, `time` in seconds. Buttons that Dear ImGui does not know are left out.
  void changed(int button, bool down, double time);

  /// Sets the buttons of the frame that begins, and how long ago the first of two clicks may be.
  void apply(ImGuiIO& io);

  /// Another frame is needed.
  bool waiting() const { return !changes_.empty(); }

 private:
  struct Change {
    int button;
    bool down, doubles;
  };

  std::deque<Change> changes_;
  std::array<bool, ImGuiMouseButton_COUNT> down_{};
  std::array<double, ImGuiMouseButton_COUNT> pressed_at_{-1, -1, -1, -1, -1};
};

}  // namespace pupflow::window
