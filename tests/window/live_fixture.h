// A window of `pupflow live` on a display of its own. It says on standard output what happens in it
// (--test-events); whoever waits here waits for such a line.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pupflow/parameters.h"
#include "tests/support/scratch.h"
#include "tests/window/child.h"
#include "tests/window/screen.h"

namespace pupflow::testing {

/// A rectangle in window coordinates.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  int middle_x() const { return x + width / 2; }
  int middle_y() const { return y + height / 2; }
};

/// A widget as its line says it.
struct Widget {
  Box box;
  std::string panel;
  Box shown;             // the part of the panel that shows widgets
  bool scrolls = false;  // there is more to see in the panel by scrolling
};

/// What `hash` lines say, from a simulation without any window.
std::string headless_hash(const Params& params, std::int64_t steps);

class Live : public ::testing::Test {
 protected:
  /// Every window ends when it is told to, from whatever it is doing.
  void TearDown() override { close(); }

  /// Opens the window and waits until it stands. One that was open is closed.
  void open(const std::vector<std::string>& options = {}, const Environment& variables = {});

  /// The rest of the next line that starts with `start`. Fails the test when none comes.
  std::string await(const std::string& start);

  /// Reads what is printed until nothing comes for `quiet`, and returns the lines.
  std::vector<std::string> settle(std::chrono::milliseconds quiet = std::chrono::milliseconds(500));

  /// Where a widget is; waits for it when it cannot be seen yet.
  Box widget(const std::string& name);

  /// All widgets that can be seen, by what was read so far.
  const std::map<std::string, Widget>& widgets() const { return widgets_; }

  void click(const std::string& name);

  /// Types a number into a slider as its help says: Ctrl + click, number, Enter.
  void type_into_slider(const std::string& name, const std::string& text);

  /// Replaces what the field with the keyboard holds, and ends with Enter.
  void enter(const std::string& text);
  /// The same, until the field has no keyboard any more.
  void type(const std::string& text);

  int exit_code() { return window_->wait().value_or(-1); }

  Screen screen_;
  const test::Scratch scratch_;  // outlives the window
  std::unique_ptr<Child> window_;

 private:
  /// Ends the window with SIGTERM, unless it has ended.
  void close();
  void remember(const std::string& line);

  std::map<std::string, Widget> widgets_;
};

}  // namespace pupflow::testing
