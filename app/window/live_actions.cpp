// What keys and buttons do to the live window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "app/io/failure.h"
#include "app/window/live_window.h"
#include "app/window/run_panel.h"

namespace pupflow::window {
namespace {

constexpr double kMessageFor = 4;  // seconds

}  // namespace

void LiveWindow::carry_out() {
  for (const Action action : std::exchange(controls_.actions, {})) perform(action);
  for (Command& command : std::exchange(controls_.commands, {})) runner_.send(std::move(command));
}

void LiveWindow::perform(Action action) {
  const auto look_from = [&](const char* spec) {
    arena_.look_from(spec);
    touched_ = true;
  };
  frames_wanted_ = std::max(frames_wanted_, 1);  // the panels show what comes of it
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
    case Action::restart:
      controls_.commands.push_back(Restart{});
      break;
    case Action::new_seed: {
      Params candidate = controls_.params;
      candidate.seed = new_seed();
      controls_.propose(candidate);
      break;
    }
    case Action::faster:
      controls_.set_speed(2 * controls_.speed);
      break;
    case Action::slower:
      controls_.set_speed(controls_.as_fast ? controls_.speed : controls_.speed / 2);
      break;
    case Action::real_time:
      controls_.set_speed(1);
      break;
    case Action::as_fast_as_possible:
      controls_.set_as_fast(!controls_.as_fast);
      break;
    case Action::reset_camera:
      look_from(ArenaView::kUsualCamera);
      break;
    case Action::top_view:
      look_from("top");
      break;
    case Action::side_view:
      look_from("side");
      break;
    case Action::screenshot:
      take_picture();
      break;
    case Action::toggle_panels:
      controls_.panels = !controls_.panels;
      break;
    case Action::toggle_help:
      controls_.help = !controls_.help;
      break;
    case Action::quit:
      if (controls_.help) {
        controls_.help = false;
      } else {
        glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
      }
      break;
  }
}

void LiveWindow::take_picture() {
  const Snapshot& snapshot = runner_.snapshot();
  try {
    const std::string path = picture_path(job_.screenshot, snapshot.step);
    arena_.write_picture(path, snapshot, controls_.look);
    events_.screenshot(path);
    show("saved " + path);
  } catch (const io::Failure& failure) {
    show(failure.what());  // a full disk is no reason to lose the litter
  }
}

void LiveWindow::show(const std::string& message) {
  message_ = message;
  message_until_ = glfwGetTime() + kMessageFor;
}

}  // namespace pupflow::window
