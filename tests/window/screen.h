// A display of the test's own, and hands to work it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/window/child.h"

namespace pupflow::testing {

/// An Xvfb on a display number that it chose itself, so that tests may run side by side.
class Screen {
 public:
  /// Throws std::runtime_error when there is no Xvfb.
  Screen();

  /// What a program needs to find this display, and to draw by the processor.
  Environment environment() const;

  /// As ":7".
  const std::string& display() const { return display_; }

  /// Runs xdotool with these arguments. Throws std::runtime_error when it fails.
  void hand(const std::vector<std::string>& arguments) const;

  /// Asks the program's window to close, as a window manager's button does. Throws
  /// std::runtime_error without one.
  void close_window() const;

  void press(const std::string& key) const { hand({"key", key}); }
  void click(int x, int y) const;

  /// Presses at (x0, y0) and moves to (x1, y1) in small steps; then it is for `release`.
  void press_and_move(int x0, int y0, int x1, int y1) const;
  void release() const { hand({"mouseup", "1"}); }

 private:
  Child server_;
  std::string display_;
};

}  // namespace pupflow::testing
