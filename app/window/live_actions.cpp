// What keys, buttons and the mouse do in the live window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "app/io/failure.h"
#include "app/window/history_csv.h"
#include "app/window/live_window.h"
#include "app/window/panel_keys.h"

namespace pupflow::window {
namespace {

constexpr double kZoomPerNotch = 1.1;

LiveWindow& window_of(GLFWwindow* handle) {
  return *static_cast<LiveWindow*>(glfwGetWindowUserPointer(handle));
}

/// A random seed, short enough to read out and type.
double new_seed() {
  std::random_device device;
  return device() % 1'000'000u;
}

}  // namespace

void LiveWindow::install_callbacks() {
  GLFWwindow* const handle = window_.handle();
  glfwSetWindowUserPointer(handle, this);
  const auto event = [](GLFWwindow* w, auto...) { window_of(w).schedule_.event(); };
  glfwSetCharCallback(handle, event);
  glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int button, int action, int) {
    window_of(w).schedule_.event();
    if (window_of(w).gui_) window_of(w).gui_->mouse_button(button, action);
  });
  glfwSetScrollCallback(handle, event);
  glfwSetCursorPosCallback(handle, [](GLFWwindow* w, double x, double y) {
    window_of(w).schedule_.event();
    if (window_of(w).gui_) window_of(w).gui_->mouse_moved(x, y);
  });
  glfwSetCursorEnterCallback(handle, event);
  glfwSetWindowFocusCallback(handle, event);
  glfwSetWindowRefreshCallback(handle, [](GLFWwindow* w) {
    window_of(w).painter_.forget();
    window_of(w).schedule_.event();
  });
  glfwSetFramebufferSizeCallback(handle, event);
  glfwSetWindowContentScaleCallback(handle, event);
  glfwSetWindowCloseCallback(handle, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    window_of(w).schedule_.event();
    window_of(w).quit();
  });
  glfwSetDropCallback(handle, [](GLFWwindow* w, int count, const char** paths) {
    window_of(w).schedule_.event();
    if (count > 0) window_of(w).open_dropped(paths[0]);
  });
}

void LiveWindow::install_key_callback() {
  glfwSetKeyCallback(window_.handle(),
                     [](GLFWwindow* w, int code, int scancode, int action, int mods) {
                       LiveWindow& window = window_of(w);
                       window.schedule_.event();
                       // Tab goes through the pups; Dear ImGui would go to the next text field.
                       const bool panels = text_has_keyboard() || keys_work_panels();
                       if (code != GLFW_KEY_TAB || panels) {
                         window.gui_->key(code, scancode, action, mods);
                       }
                       if (action == GLFW_RELEASE) return;
                       window.key(layout_key(code, scancode), mods, action == GLFW_REPEAT);
                     });
}

/// Dear ImGui goes on wanting text for a moment after a field was left.
bool LiveWindow::text_has_keyboard() {
  return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
}

void LiveWindow::key(int code, int mods, bool repeated) {
  if (dialogs_.shown()) {
    if (code == GLFW_KEY_ESCAPE) dialogs_.cancel();
    if (code == GLFW_KEY_ENTER || code == GLFW_KEY_KP_ENTER) dialogs_.accept();
    return;
  }
  const bool enter = code == GLFW_KEY_ENTER || code == GLFW_KEY_KP_ENTER;
  if (text_has_keyboard() && !std::exchange(typing_ends_, typing_ends_ || enter)) return;
  if (panels_take(code)) return;
  if (const auto action = action_for(code, mods, repeated)) controls_.actions.push_back(*action);
}

void LiveWindow::move_camera(const Area& arena, double now) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  if (clicked && keys_work_panels()) leave_panels();
  if (io.WantCaptureMouse) return;
  const auto share = [&](float pixels) { return static_cast<double>(pixels / arena.size.y); };
  const double dx = share(io.MouseDelta.x), dy = share(io.MouseDelta.y);
  // A move before the press does not count.
  const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                       ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                       ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left) && !pulled_;
  const bool other =
      ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  if ((dx != 0 || dy != 0) && !pressed) {
    const bool moves = other || (left && io.KeyShift);
    const bool eye = controls_.camera_mode == CameraMode::eye;
    if ((moves || left) && (eye || moves)) controls_.camera_mode = CameraMode::free;
    if (eye) return;
    if (moves) {
      arena_.pan(dx, -dy);
      schedule_.view_moved(now);
    } else if (left) {
      arena_.orbit(-std::numbers::pi * dx, std::numbers::pi * dy);
      schedule_.view_moved(now);
    }
  }
  if (io.MouseWheel != 0 && arena.holds(io.MousePos)) {
    const ImVec2 middle = arena.middle();
    arena_.zoom_at(std::pow(kZoomPerNotch, io.MouseWheel), share(io.MousePos.x - middle.x),
                   share(middle.y - io.MousePos.y));
    schedule_.view_moved(now);
  }
}

void LiveWindow::carry_out(double now) {
  for (const Action action : std::exchange(controls_.actions, {})) perform(action, now);
  if (const auto steps = std::exchange(controls_.save_csv, {})) save_csv(*steps);
  if (!controls_.message.empty()) show(std::exchange(controls_.message, {}));
  for (Command& command : std::exchange(controls_.commands, {})) {
    film_follows(command);
    runner_.send(std::move(command));
  }
}

void LiveWindow::perform(Action action, double now) {
  const auto look_from = [&](const char* spec) {
    if (controls_.camera_mode == CameraMode::eye) controls_.camera_mode = CameraMode::free;
    guide_ = {};
    arena_.look_from(view::Camera::parse(spec));
    schedule_.view_moved(now);
  };
  const LiveState& shown = runner_.snapshot();
  const auto go_by = [&](std::int64_t steps) {
    controls_.go_to(controls_.shown_step(shown) + steps, shown.timeline);
  };
  schedule_.panels_changed();  // the next frame shows the result
  if (film_takes(action)) return;
  switch (action) {
    case Action::play_pause:
      controls_.commands.push_back(PlayPause{});
      break;
    case Action::step:
      controls_.commands.push_back(Advance{1});
      break;
    case Action::step_many:
      controls_.commands.push_back(Advance{kManySteps});
      break;
    case Action::step_back:
      go_by(-1);
      break;
    case Action::step_back_many:
      go_by(-kManySteps);
      break;
    case Action::to_start:
      controls_.go_to(shown.timeline.first, shown.timeline);
      break;
    case Action::to_end:
      controls_.go_to(shown.timeline.last, shown.timeline);
      break;
    case Action::undo:
      controls_.commands.push_back(Undo{});
      break;
    case Action::redo:
      controls_.commands.push_back(Redo{});
      break;
    case Action::restart:
      controls_.commands.push_back(Restart{});
      break;
    case Action::new_seed:
      controls_.propose(*find_parameter("seed"), new_seed());
      break;
    case Action::faster:
      controls_.faster();
      break;
    case Action::slower:
      controls_.slower();
      break;
    case Action::real_time:
      controls_.set_speed(1);
      break;
    case Action::as_fast_as_possible:
      controls_.set_as_fast(!controls_.as_fast);
      break;
    case Action::reset_camera:
      look_from(view::Camera::kUsual);
      break;
    case Action::top_view:
      look_from("top");
      break;
    case Action::side_view:
      look_from("side");
      break;
    case Action::next_pup:
    case Action::previous_pup:
    case Action::follow_pup:
    case Action::pups_eye:
      perform_on_pup(action);
      break;
    case Action::screenshot:
      take_picture();
      break;
    case Action::toggle_panels:
      (controls_.narrow ? controls_.drawer : controls_.panels) ^= true;
      break;
    case Action::toggle_help:
      controls_.help = !controls_.help;
      break;
    case Action::work_panels:
      work_next_panel(Panels::names());
      show("Arrows move, Space presses, Enter types. F6: the next panel. Esc: back to the arena.");
      break;
    case Action::close:
      close_front();
      break;
    case Action::quit:
      quit();
      break;
    default:
      desk_action(action);
      break;
  }
}

/// One thing at a time, that in front first. Text fields deal with Esc themselves.
void LiveWindow::close_front() {
  if (close_front_popup()) return;
  if (controls_.help) {
    controls_.help = false;
  } else if (keys_work_panels()) {
    leave_panels();
  } else if (controls_.narrow && controls_.drawer) {
    controls_.drawer = false;
  } else if (controls_.camera_mode != CameraMode::free) {
    controls_.camera_mode = CameraMode::free;
  } else {
    controls_.selected.reset();
  }
}

void LiveWindow::save_csv(StepRange steps) {
  try {
    const std::string path = save_history_csv(job_.screenshot, runner_.snapshot(), steps);
    events_.note("saved", path);
    show("saved " + path);
  } catch (const io::Failure& failure) {
    show(failure.what());
  }
}

/// As long as it takes to read.
void LiveWindow::show(const std::string& message) {
  constexpr double kOfCharacter = 0.06, kLongest = 12;  // seconds
  message_ = message;
  const double reading = kOfCharacter * static_cast<double>(message.size());
  schedule_.message_shown(glfwGetTime(),
                          std::clamp(reading, RedrawSchedule::kMessageSeconds, kLongest));
  schedule_.event();  // its box takes a frame to fit
}

}  // namespace pupflow::window
