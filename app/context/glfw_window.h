// A window with OpenGL, by GLFW.
#pragma once

#include <string>

#include "app/context/context.h"

struct GLFWwindow;

namespace pupflow::context {

struct WindowOptions {
  std::string title = "pupflow";
  int width = 640, height = 480;  // screen coordinates
  bool visible = true;
};

/// Owns GLFW and one window with an OpenGL 3.3 core context. One at a time, on the main thread.
class GlfwWindow final : public Context {
 public:
  /// Opens the window and makes its context current. Throws Failure(no_context) with GLFW's own
  /// words when there is no display or no OpenGL 3.3.
  explicit GlfwWindow(const WindowOptions& options);
  ~GlfwWindow() override;

  void make_current() override;
  void release_current() override;
  std::string name() const override;

  GLFWwindow* handle() const { return window_; }

  /// Factor by which the display wants text and widgets enlarged (1 on an ordinary screen).
  double content_scale() const;

 private:
  GLFWwindow* window_ = nullptr;
};

/// A second context of a window, which sees the textures of the first, for a thread of its own. Made
/// and destroyed on the main thread, current on no other then.
class SharedContext final : public Context {
 public:
  /// Throws Failure(no_context).
  explicit SharedContext(const GlfwWindow& window);
  ~SharedContext() override;

  void make_current() override;
  void release_current() override;
  std::string name() const override;

 private:
  GLFWwindow* window_;  // never shown
};

/// Whether a window can be had: opens an invisible one and closes it.
ContextReport probe_window();

}  // namespace pupflow::context
