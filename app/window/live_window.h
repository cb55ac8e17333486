// The window's loop: events in, commands to the runner, frames out.
#pragma once

#include <memory>
#include <string>

#include "app/context/glfw_window.h"
#include "app/window/arena_view.h"
#include "app/window/controls.h"
#include "app/window/gui.h"
#include "app/window/live_job.h"
#include "app/window/panels/panels.h"
#include "app/window/session/redraw_schedule.h"
#include "app/window/session/runner.h"
#include "app/window/test_events.h"

namespace pupflow::window {

/// One window with one litter, on the main thread. Sleeps until an event or a snapshot arrives, and
/// draws a frame only when the schedule says that one is due.
class LiveWindow {
 public:
  /// Opens the window. Throws Failure and InvalidParams.
  explicit LiveWindow(const LiveJob& job);
  LiveWindow(const LiveWindow&) = delete;
  LiveWindow& operator=(const LiveWindow&) = delete;

  /// Returns when the window is closed. Throws Failure(interrupted) after Ctrl-C.
  void run();

 private:
  // live_window.cpp: the loop and its frames.
  bool closing() const;
  void wait_for_events();
  void follow_visibility();
  void exchange_snapshots(double now);
  void frame(double now);
  Layout lay_out();
  void fit_scale();
  void paint(const Layout& layout);

  // live_actions.cpp: what keys, buttons and the mouse do.
  void install_callbacks();
  void install_key_callback();
  void key(int code, int mods, bool repeated);
  static bool text_has_keyboard();
  void move_camera(const Area& arena, double now);
  void carry_out(double now);
  void perform(Action action, double now);
  void close_front();
  void take_picture();
  void save_csv(StepRange steps);
  void show(const std::string& message);

  LiveJob job_;
  context::GlfwWindow window_;  // outlives everything that lives in its context
  ArenaView arena_;
  std::unique_ptr<Gui> gui_;  // made after this window's own callbacks, which it then calls
  Controls controls_;
  Panels panels_;
  TestEvents events_;
  Tips tips_;
  Runner runner_;
  RedrawSchedule schedule_;
  std::string message_;
  view::ColorScale scale_;  // the look's, fitted to the snapshot that is shown
  double scale_time_ = 0;   // model seconds of the snapshot that it was fitted to
};

}  // namespace pupflow::window
