#include "app/window/live_window.h"

#include <GL/glew.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "app/gl/load.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::window {
namespace {

constexpr int kSettle = 3;              // frames after an event
constexpr double kFrame = 1.0 / 60;     // shortest time between two snapshots
constexpr double kLongestSleep = 0.25;  // Ctrl-C is looked for this often
constexpr double kCursorBlink = 0.25;
constexpr double kStill = 0.2;  // rest before the sharp frame
constexpr double kZoomPerNotch = 1.1;

LiveWindow& window_of(GLFWwindow* handle) {
  return *static_cast<LiveWindow*>(glfwGetWindowUserPointer(handle));
}

/// Dear ImGui goes on wanting text for a moment after a field was left.
bool text_has_keyboard() {
  return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
}

bool drawn_by_processor() {
  const std::string name = gl::renderer_name();
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos ||
         name.find("SwiftShader") != std::string::npos;
}

}  // namespace

LiveWindow::LiveWindow(const pictures::LiveJob& job)
    : job_(job),
      window_({.title = "pupflow", .width = job.width, .height = job.height}),
      arena_(job.look),
      events_(job.test_events),
      runner_({.params = job.params,
               .playing = !job.paused,
               .threads = job.threads,
               .hashed = job.test_events,
               .notify = [] { glfwPostEmptyEvent(); }}) {
  picture_path(job.screenshot, 0);  // a bad pattern fails now, not when a picture is wanted
  controls_.params = job.params;
  controls_.look = job.look;
  install_callbacks();
  gui_ = std::make_unique<Gui>(window_, job.ui_scale);
  install_key_callback();
  glfwSwapInterval(1);
  slow_gl_ = drawn_by_processor();
  if (job.look.verbose) {
    std::cerr << "OpenGL: " << window_.name() << ", " << gl::renderer_name() << ", "
              << gl::version_text() << '\n';
  }
}

void LiveWindow::install_callbacks() {
  GLFWwindow* const handle = window_.handle();
  glfwSetWindowUserPointer(handle, this);
  glfwSetCharCallback(handle,
                      [](GLFWwindow* w, unsigned) { window_of(w).frames_wanted_ = kSettle; });
  glfwSetMouseButtonCallback(
      handle, [](GLFWwindow* w, int, int, int) { window_of(w).frames_wanted_ = kSettle; });
  glfwSetScrollCallback(
      handle, [](GLFWwindow* w, double, double) { window_of(w).frames_wanted_ = kSettle; });
  glfwSetCursorPosCallback(
      handle, [](GLFWwindow* w, double, double) { window_of(w).frames_wanted_ = kSettle; });
  const auto redraw = [](GLFWwindow* w, int) { window_of(w).frames_wanted_ = kSettle; };
  glfwSetCursorEnterCallback(handle, redraw);
  glfwSetWindowFocusCallback(handle, redraw);
  glfwSetWindowRefreshCallback(handle,
                               [](GLFWwindow* w) { window_of(w).frames_wanted_ = kSettle; });
  glfwSetFramebufferSizeCallback(
      handle, [](GLFWwindow* w, int, int) { window_of(w).frames_wanted_ = kSettle; });
  glfwSetWindowContentScaleCallback(
      handle, [](GLFWwindow* w, float, float) { window_of(w).frames_wanted_ = kSettle; });
}

void LiveWindow::install_key_callback() {
  glfwSetKeyCallback(window_.handle(),
                     [](GLFWwindow* w, int code, int scancode, int action, int mods) {
                       LiveWindow& window = window_of(w);
                       window.frames_wanted_ = kSettle;
                       window.gui_->key(code, scancode, action, mods);
                       if (action == GLFW_RELEASE) return;
                       window.key(layout_key(code, scancode), mods, action == GLFW_REPEAT);
                     });
}

void LiveWindow::key(int code, int mods, bool repeated) {
  if (text_has_keyboard()) return;
  if (const auto action = action_for(code, mods, repeated)) controls_.actions.push_back(*action);
}

void LiveWindow::run() {
  while (!glfwWindowShouldClose(window_.handle())) {
    sleep_until_event();
    if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
    const double now = glfwGetTime();
    if (job_.exit_after > 0 && now >= job_.exit_after) return;
    follow_visibility();
    if (!visible_) continue;
    exchange_snapshots(now);
    if (frame_due(now)) frame(now);
  }
}

void LiveWindow::sleep_until_event() {
  if (visible_ && (frames_wanted_ > 0 || fresh_)) {
    glfwPollEvents();
  } else {
    glfwWaitEventsTimeout(std::max(sleep_limit(glfwGetTime()), 1e-4));
  }
}

double LiveWindow::sleep_limit(double now) const {
  double until = now + kLongestSleep;
  if (job_.exit_after > 0) until = std::min(until, job_.exit_after);
  if (!visible_) return until - now;
  if (!requested_) until = std::min(until, request_at_);
  if (!sharp_) until = std::min(until, sharpen_at_);
  if (!message_.empty()) until = std::min(until, message_until_);
  return until - now;
}

void LiveWindow::follow_visibility() {
  const bool visible = glfwGetWindowAttrib(window_.handle(), GLFW_VISIBLE) == GLFW_TRUE &&
                       glfwGetWindowAttrib(window_.handle(), GLFW_ICONIFIED) == GLFW_FALSE;
  if (visible == visible_) return;
  visible_ = visible;
  runner_.send(Suspend{!visible});
  frames_wanted_ = kSettle;
}

void LiveWindow::exchange_snapshots(double now) {
  if (runner_.take()) {
    const Snapshot& snapshot = runner_.snapshot();
    started_ = fresh_ = true;
    requested_ = false;
    events_.snapshot(snapshot);
    if (!snapshot.rejected.empty()) controls_.params = snapshot.params;
  }
  if (requested_ || now < request_at_) return;
  runner_.request();
  requested_ = true;
}

bool LiveWindow::frame_due(double now) const {
  return started_ && (frames_wanted_ > 0 || fresh_ || (!sharp_ && now >= sharpen_at_) ||
                      (!message_.empty() && now >= message_until_) ||
                      (gui_ && ImGui::GetIO().WantTextInput && now >= request_at_ + kCursorBlink));
}

void LiveWindow::frame(double now) {
  frames_wanted_ = std::max(frames_wanted_ - 1, 0);
  request_at_ = now + kFrame;
  if (fresh_) {
    const double since = now - last_fresh_;
    frame_seconds_ =
        since > 0.5 || frame_seconds_ == 0 ? since : 0.9 * frame_seconds_ + 0.1 * since;
    last_fresh_ = now;
  }
  if (now >= message_until_) message_.clear();

  gui_->begin_frame();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Layout layout = make_layout(size.x, size.y, gui_->scale(), controls_.panels);
  const Snapshot& snapshot = runner_.snapshot();
  const double rate = snapshot.playing && frame_seconds_ > 0 ? 1 / frame_seconds_ : 0;
  const bool observed = panels_.draw(layout, snapshot, rate, controls_, gui_->fonts(), events_);
  draw_message(layout.arena, message_);
  move_camera(layout.arena);
  events_.text(text_has_keyboard());
  gui_->end_frame();

  if (observed != observed_) controls_.commands.push_back(Observe{observed});
  observed_ = observed;
  carry_out();
  paint(layout, now);
}

void LiveWindow::move_camera(const Area& arena) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse) return;
  const auto share = [&](float pixels) { return static_cast<double>(pixels / arena.size.y); };
  const double dx = share(io.MouseDelta.x), dy = share(io.MouseDelta.y);
  // The way that the mouse came before the press does not count.
  const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                       ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                       ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool other =
      ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  if ((dx != 0 || dy != 0) && !pressed) {
    if (other || (left && io.KeyShift)) {
      arena_.pan(dx, -dy);
      touched_ = true;
    } else if (left) {
      arena_.orbit(-std::numbers::pi * dx, std::numbers::pi * dy);
      touched_ = true;
    }
  }
  if (io.MouseWheel != 0 && arena.holds(io.MousePos)) {
    arena_.zoom(std::pow(kZoomPerNotch, io.MouseWheel));
    touched_ = true;
  }
}

void LiveWindow::paint(const Layout& layout, double now) {
  if (fresh_ || touched_) sharpen_at_ = now + kStill;
  sharp_ = !slow_gl_ || now >= sharpen_at_;
  const auto pixels = [&](float length) {
    return static_cast<int>(std::lround(length * gui_->density()));
  };
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.handle(), &width, &height);
  const int x = pixels(layout.arena.corner.x);
  const int arena_width = std::min(pixels(layout.arena.size.x), width - x);
  if (height <= 0 || arena_width <= 0) return;
  arena_.draw(runner_.snapshot(), fresh_, controls_.look, arena_width, height,
              sharp_ ? controls_.look.supersample : 1);
  fresh_ = touched_ = false;
  events_.camera(arena_.camera());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const view::Rgb paper = gl::Palette{}.background;
  glClearColor(static_cast<float>(paper.r) / 255, static_cast<float>(paper.g) / 255,
               static_cast<float>(paper.b) / 255, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  arena_.show(x, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  gui_->draw();
  glfwSwapBuffers(window_.handle());
}

}  // namespace pupflow::window
