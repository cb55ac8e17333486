#include "tests/window/screen.h"

#include <stdexcept>

#include "tests/window/x_client.h"

namespace pupflow::testing {
namespace {

constexpr int kDragSteps = 8;
constexpr const char* kBetweenMoves = "0.1";  // seconds; a hand is no faster

}  // namespace

Screen::Screen()
    : server_({.arguments = {"Xvfb", "-displayfd", "1", "-screen", "0", "1600x1000x24",
                             "+extension", "GLX", "-nolisten", "tcp"},
               .environment = {},
               .folder = {}}) {
  const auto number = server_.read_line();
  if (!number) throw std::runtime_error("Xvfb did not start: " + server_.errors());
  display_ = ":" + *number;
}

Environment Screen::environment() const {
  return {"DISPLAY=" + display_, "LIBGL_ALWAYS_SOFTWARE=1", "WAYLAND_DISPLAY"};
}

void Screen::hand(const std::vector<std::string>& arguments) const {
  std::vector<std::string> all{"xdotool"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  if (run_command({.arguments = all, .environment = environment(), .folder = {}}) != 0) {
    throw std::runtime_error("xdotool " + arguments.front() + " failed");
  }
}

void Screen::close_window() const {
  if (!XClient(display_).close_windows()) throw std::runtime_error("no window to close");
}

void Screen::click(int x, int y) const {
  hand({"mousemove", std::to_string(x), std::to_string(y), "sleep", kBetweenMoves, "mousedown", "1",
        "sleep", kBetweenMoves, "mouseup", "1"});
}

void Screen::press_and_move(int x0, int y0, int x1, int y1) const {
  std::vector<std::string> moves{
      "mousemove", std::to_string(x0), std::to_string(y0), "sleep", kBetweenMoves, "mousedown", "1",
      "sleep",     kBetweenMoves};
  for (int i = 1; i <= kDragSteps; ++i) {
    moves.insert(moves.end(),
                 {"mousemove", std::to_string(x0 + (x1 - x0) * i / kDragSteps),
                  std::to_string(y0 + (y1 - y0) * i / kDragSteps), "sleep", kBetweenMoves});
  }
  hand(moves);
}

}  // namespace pupflow::testing
