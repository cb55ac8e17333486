#include "app/context/glfw_window.h"

// GLEW declares OpenGL itself and must not meet GLFW's own declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "app/gl/load.h"
#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::context {

namespace {

/// The value of an environment variable, "" where it has none.
std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// Refuses: the display that the environment names, if it does, `does_not`.
[[noreturn]] void fail(const std::string& does_not) {
  std::vector<std::string> displays;
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    if (const std::string value = environment(name); !value.empty()) {
      displays.push_back(io::quoted(value));
    }
  }
  const std::string what = displays.empty()
                               ? "no display is here"
                               : "display " + io::joined(displays, " or ") + " " + does_not;
  throw io::Failure(io::ExitCode::no_context,
                    what +
                        "; a window needs a display (DISPLAY or WAYLAND_DISPLAY) and an "
                        "OpenGL 3.3 driver (libgl1-mesa-dri)");
}

/// GLFW 3.4 tries Wayland first, whose library complains on standard error where there is none.
void choose_platform() {
#ifdef GLFW_PLATFORM
  const bool x11 = environment("WAYLAND_DISPLAY").empty() &&
                   glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE;
  glfwInitHint(GLFW_PLATFORM, x11 ? GLFW_PLATFORM_X11 : GLFW_ANY_PLATFORM);
#endif
}

void ask_for_opengl(bool visible) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  for (const int bits : {GLFW_DEPTH_BITS, GLFW_STENCIL_BITS}) glfwWindowHint(bits, 0);
  glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
}

}  // namespace

GlfwWindow::GlfwWindow(const WindowOptions& options) {
  choose_platform();
  if (glfwInit() != GLFW_TRUE) fail("does not answer");
  ask_for_opengl(options.visible);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  try {
    window_ =
        glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) fail("opens no window with OpenGL 3.3");
    make_current();
    gl::load_functions();
  } catch (...) {
    glfwTerminate();  // destroys the window too
    throw;
  }
}

GlfwWindow::~GlfwWindow() {
  glfwTerminate();
}

void GlfwWindow::make_current() {
  glfwMakeContextCurrent(window_);
}

void GlfwWindow::release_current() {
  glfwMakeContextCurrent(nullptr);
}

std::string GlfwWindow::name() const {
  return "GLFW window";
}

double GlfwWindow::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::max(x, y);
}

SharedContext::SharedContext(const GlfwWindow& window) {
  ask_for_opengl(false);
  window_ = glfwCreateWindow(1, 1, "", nullptr, window.handle());
  if (window_ == nullptr) fail("gives the window no second context");
}

SharedContext::~SharedContext() {
  glfwDestroyWindow(window_);
}

void SharedContext::make_current() {
  glfwMakeContextCurrent(window_);
}

void SharedContext::release_current() {
  glfwMakeContextCurrent(nullptr);
}

std::string SharedContext::name() const {
  return "GLFW context";
}

ContextReport probe_window() {
  ContextReport report;
  try {
    WindowOptions options;
    options.visible = false;
    const GlfwWindow window(options);
    report.works = true;
    report.chosen = window.name();
    report.renderer = gl::renderer_name();
    report.version = gl::version_text();
    report.tried.push_back(window.name() + ": works");
  } catch (const io::Failure& failure) {
    report.tried.push_back(std::string("GLFW window: ") + failure.what());
  }
  return report;
}

}  // namespace pupflow::context
