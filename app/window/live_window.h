// The window's loop: events in, commands to the runner, frames out.
#pragma once

#include <memory>
#include <string>

#include "app/context/glfw_window.h"
#include "app/pictures/graphics.h"
#include "app/window/arena_view.h"
#include "app/window/controls.h"
#include "app/window/gui.h"
#include "app/window/panels.h"
#include "app/window/runner.h"
#include "app/window/test_events.h"

namespace pupflow::window {

/// One window with one litter, on the main thread. Sleeps until there is an event or a snapshot,
/// and draws then and only then.
class LiveWindow {
 public:
  /// Throws Failure and InvalidParams.
  explicit LiveWindow(const pictures::LiveJob& job);
  LiveWindow(const LiveWindow&) = delete;
  LiveWindow& operator=(const LiveWindow&) = delete;

  /// Until the window is closed. Throws Failure(interrupted) after Ctrl-C.
  void run();

 private:
  void install_callbacks();
  void install_key_callback();
  void key(int code, int mods, bool repeated);

  void sleep_until_event();
  double sleep_limit(double now) const;
  void follow_visibility();
  void exchange_snapshots(double now);
  bool frame_due(double now) const;

  void frame(double now);
  void move_camera(const Area& arena);
  void carry_out();
  void perform(Action action);
  void take_picture();
  void show(const std::string& message);
  void paint(const Layout& layout, double now);

  pictures::LiveJob job_;
  context::GlfwWindow window_;  // outlives everything that lives in its context
  ArenaView arena_;
  std::unique_ptr<Gui> gui_;  // made after this window's own callbacks, which it then calls
  Controls controls_;
  Panels panels_;
  TestEvents events_;
  Runner runner_;

  bool slow_gl_ = false;  // the processor draws: what moves gets one sample a pixel
  bool visible_ = true, observed_ = false;
  bool started_ = false;    // there is a snapshot
  bool fresh_ = false;      // it has not been drawn yet
  bool requested_ = false;  // the next one is on its way
  bool touched_ = false;    // the view was changed by hand since the last frame
  bool sharp_ = true;       // the arena is drawn in full quality, or
  double sharpen_at_ = 0;   // will be then, if nothing moves until then
  int frames_wanted_ = 0;   // Dear ImGui needs a few frames to settle after an event
  double request_at_ = 0;   // when to ask for the next snapshot
  double frame_seconds_ = 0, last_fresh_ = 0;
  std::string message_;
  double message_until_ = 0;
};

}  // namespace pupflow::window
