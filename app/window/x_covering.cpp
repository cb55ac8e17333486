#include "app/window/x_covering.h"

#include <X11/Xlib.h>
#include <dlfcn.h>

namespace pupflow::window {
namespace {

/// A function that GLFW has only where it was built for X.
template <class Function>
Function find(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

struct Covering::Connection {
  explicit Connection(Display* opened) : display(opened) {}
  ~Connection() { XCloseDisplay(display); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  Display* display;
};

Covering::Covering(GLFWwindow* window) {
  const auto display_of = find<Display* (*)()>("glfwGetX11Display");
  const auto window_of = find<Window (*)(GLFWwindow*)>("glfwGetX11Window");
  if (display_of == nullptr || window_of == nullptr) return;
  Display* const others = display_of();
  const Window id = window_of(window);
  Display* const own =
      others != nullptr && id != None ? XOpenDisplay(DisplayString(others)) : nullptr;
  if (own == nullptr) return;
  connection_ = std::make_unique<Connection>(own);
  XSelectInput(own, id, VisibilityChangeMask);
  XFlush(own);
}

Covering::~Covering() = default;

bool Covering::whole() {
  while (connection_ && XPending(connection_->display) > 0) {
    XEvent event{};
    XNextEvent(connection_->display, &event);
    if (event.type == VisibilityNotify) {
      whole_ = event.xvisibility.state == VisibilityFullyObscured;
    }
  }
  return whole_;
}

}  // namespace pupflow::window
