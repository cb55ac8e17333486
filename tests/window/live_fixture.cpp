#include "tests/window/live_fixture.h"

#include <chrono>
#include <csignal>
#include <sstream>
#include <stdexcept>

#include "pupflow/simulation.h"

namespace pupflow::testing {

std::string headless_hash(const Params& params, std::int64_t steps) {
  Simulation simulation(params);
  simulation.set_observed({});
  simulation.run(steps);
  std::ostringstream text;
  text << std::hex << simulation.hash();
  return text.str();
}

void Live::open(const std::vector<std::string>& options, const Environment& variables) {
  std::vector<std::string> arguments{PUPFLOW_PROGRAM, "live", "--test-events"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  close();
  widgets_.clear();
  Environment environment = screen_.environment();
  environment.insert(environment.end(), variables.begin(), variables.end());
  window_ = std::make_unique<Child>(ChildOptions{
      .arguments = arguments, .environment = environment, .folder = scratch_.folder().string()});
  await("camera ");  // printed with the first frame, after the widgets
}

void Live::close() {
  if (window_ && window_->pid() > 0) {
    window_->send_signal(SIGTERM);
    while (window_->read_line()) continue;  // until its end
    constexpr int kInterrupted = 130;
    const int code = exit_code();
    EXPECT_TRUE(code == 0 || code == kInterrupted) << code << ": " << window_->errors();
  }
  window_.reset();
}

std::string Live::await(const std::string& start) {
  const auto give_up = std::chrono::steady_clock::now() + Child::kPatience;
  while (std::chrono::steady_clock::now() < give_up) {
    const auto line = window_->read_line();
    if (!line) break;
    remember(*line);
    if (line->starts_with(start)) return line->substr(start.size());
  }
  ADD_FAILURE() << "'" << start << "' never came; " << window_->errors();
  throw std::runtime_error("not what was waited for");
}

std::vector<std::string> Live::settle(std::chrono::milliseconds quiet) {
  constexpr std::chrono::seconds kLongest{10};  // a window that plays is never quiet for long
  const auto end = std::chrono::steady_clock::now() + kLongest;
  std::vector<std::string> lines;
  while (std::chrono::steady_clock::now() < end) {
    const auto line = window_->read_line(quiet);
    if (!line) break;
    remember(*line);
    lines.push_back(*line);
  }
  return lines;
}

Box Live::widget(const std::string& name) {
  if (widgets_.count(name) == 0) await("widget " + name + ' ');
  return widgets_.at(name).box;
}

void Live::click(const std::string& name) {
  const Box box = widget(name);
  screen_.click(box.middle_x(), box.middle_y());
}

void Live::type_into_slider(const std::string& name, const std::string& text) {
  screen_.hand({"keydown", "Control_L"});
  click(name);
  await("text on");
  screen_.hand({"keyup", "Control_L"});
  type(text);
}

void Live::enter(const std::string& text) {
  // Before Dear ImGui 1.87 a frame sees Ctrl-A behind text that comes within the same frame.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  const std::string frames = "0.8";  // seconds
#else
  const std::string frames = "0.15";
#endif
  screen_.hand({"sleep", frames, "key", "ctrl+a", "sleep", frames, "type", "--delay", "60", text});
  screen_.hand({"sleep", frames, "key", "Return"});
}

void Live::type(const std::string& text) {
  enter(text);
  await("text off");
}

void Live::remember(const std::string& line) {
  std::istringstream words(line);
  std::string kind, name, in, more;
  words >> kind >> name;
  if (kind == "gone") widgets_.erase(name);
  if (kind != "widget") return;
  const auto read = [&](Box& box) { words >> box.x >> box.y >> box.width >> box.height; };
  Widget widget;
  read(widget.box);
  words >> in >> widget.panel;
  read(widget.shown);
  widget.scrolls = words >> more && more == "scrolls";
  widgets_[name] = widget;
}

}  // namespace pupflow::testing
