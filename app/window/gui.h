// Dear ImGui in a GLFW window: set-up, scale, frames.
#pragma once

#include <optional>
#include <vector>

#include "app/context/glfw_window.h"
#include "app/window/mouse_buttons.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// Owns the Dear ImGui context of one window, whose OpenGL context must be current throughout. Its
/// callbacks call those that were installed before it; the key callback it leaves to its owner.
class Gui {
 public:
  /// The theme and scale to begin with.
  Gui(const context::GlfwWindow& window, double ui_scale, Theme theme);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Passes on what GLFW's key callback was told. A tap shorter than a frame still lasts for one.
  void key(int code, int scancode, int action, int mods);

  /// Passes on what GLFW's callback for mouse buttons was told.
  void mouse_button(int button, int action);
  /// And where the mouse is, in window coordinates; its buttons change there.
  void mouse_moved(double x, double y);
  /// There are clicks left for the frames to come.
  bool clicks_wait() const { return buttons_.waiting(); }

  /// From the next frame on. `ui_scale` enlarges text and widgets; 0 follows the display, also when
  /// the window moves to another one.
  void set_scale(double ui_scale) { ui_scale_ = ui_scale; }
  void set_theme(Theme theme) { theme_ = theme; }

  /// Between these two panels may be submitted.
  void begin_frame();
  void end_frame();

  /// Draws the frame just ended into the framebuffer that is bound.
  void draw();

  const Fonts& fonts() const { return fonts_; }
  float scale() const { return scale_; }      // of widgets, in window coordinates
  float density() const { return density_; }  // framebuffer pixels per window coordinate

 private:
  struct Release {
    int code, scancode, mods;
  };

  void follow_scale();

  const context::GlfwWindow& window_;
  double ui_scale_;
  Theme theme_;
  std::optional<Theme> applied_;
  float scale_ = 0, density_ = 0;
  Fonts fonts_;
  MouseButtons buttons_;
  std::vector<int> pressed_;       // keys that went down since the last frame
  std::vector<Release> released_;  // of these, those that are up again
};

}  // namespace pupflow::window
