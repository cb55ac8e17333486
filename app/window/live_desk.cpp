// Scenes, settings and closing of the live window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/io/failure.h"
#include "app/io/note.h"
#include "app/io/text.h"
#include "app/window/live_window.h"

namespace pupflow::window {
namespace {

namespace fs = std::filesystem;

/// What Ctrl + and Ctrl - go through.
constexpr double kScales[] = {0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4};

std::string folder_of(const std::string& path) {
  std::error_code unknown;
  return path.empty() ? fs::current_path(unknown).string() : fs::path(path).parent_path().string();
}

}  // namespace

/// Whether there is something to lose: edits, also those on their way to the runner.
bool LiveWindow::changed() const {
  return desk_.changed(runner_.snapshot().view().recipe) || edits_on_their_way();
}

/// Whether the runner has not yet taken all that was set.
bool LiveWindow::edits_on_their_way() const {
  const LitterView litter = runner_.snapshot().view();
  return !std::ranges::all_of(parameters(), [&](const Parameter& parameter) {
    return parameter.get(controls_.params) == parameter.get(litter.params);
  });
}

/// Within a frame, behind the panels.
void LiveWindow::desk_frame(const PanelInput& input) {
  if (!controls_.open.empty()) {
    open(std::exchange(controls_.open, {}));
  }
  if (auto given = dialogs_.draw(input)) wait_with(std::move(*given));
  carry_out_answer();
  if (dialogs_.shown()) schedule_.panels_changed();
  show_title();
  keep_settings();
}

void LiveWindow::desk_action(Action action) {
  switch (action) {
    case Action::record:
      switch_film();
      break;
    case Action::open:
      dialogs_.ask_open(folder_of(desk_.path()));
      break;
    case Action::save:
      wait_with({Dialogs::Answer::Kind::save, {}});
      break;
    case Action::save_as:
      ask_for_name();
      break;
    case Action::copy_command:
      copy_command();
      break;
    case Action::larger:
      resize_text(1);
      break;
    case Action::smaller:
      resize_text(-1);
      break;
    case Action::usual_size:
      resize_text(0);
      break;
    case Action::switch_theme:
      settings_.theme = settings_.theme == Theme::light ? Theme::dark : Theme::light;
      gui_->set_theme(settings_.theme);
      events_.note("theme", settings_.theme == Theme::light ? "light" : "dark");
      break;
    case Action::full_screen:
      switch_full_screen();
      break;
    default:
      break;
  }
}

/// Does `next` at once where nothing would be lost; otherwise asks first, in words: "before WHAT".
void LiveWindow::ask_before(const std::string& what, std::function<void()> next) {
  if (!changed()) {
    next();
    return;
  }
  next_ = std::move(next);
  dialogs_.ask_keep(desk_.title(), what);
}

void LiveWindow::wait_with(Dialogs::Answer answer) {
  waiting_ = std::move(answer);
  waiting_since_ = glfwGetTime();
}

/// As soon as the runner has taken all that was set; or after kPatience, to say that it has not.
void LiveWindow::carry_out_answer() {
  constexpr double kPatience = 2;  // seconds
  if (!waiting_) return;
  const double end = waiting_since_ + kPatience;
  if (edits_on_their_way() && glfwGetTime() < end) {
    schedule_.wake_at(end);
  } else {
    answer(*std::exchange(waiting_, {}));
  }
}

void LiveWindow::answer(const Dialogs::Answer& answer) {
  using Kind = Dialogs::Answer::Kind;
  const auto go_on = [&] {
    if (const auto next = std::exchange(next_, nullptr)) next();
  };
  switch (answer.kind) {
    case Kind::open:
      open(answer.path);
      break;
    case Kind::save_as:
      if (!save_as(answer.path)) break;
      dialogs_.cancel();
      go_on();
      break;
    case Kind::save:
      if (desk_.path().empty()) {
        const auto next = std::move(next_);
        ask_for_name();
        next_ = next;
      } else if (save_as(desk_.path())) {
        go_on();
      }
      break;
    case Kind::discard:
      go_on();
      break;
  }
}

void LiveWindow::ask_for_name() {
  next_ = nullptr;
  dialogs_.ask_save(folder_of(desk_.path()), desk_.file_name());
}

/// Whether it was saved.
bool LiveWindow::save_as(const std::string& path) {
  const LitterView litter = runner_.snapshot().view();
  try {
    if (edits_on_their_way())
      io::refuse("not saved: the last edit is not yet in force; save again");
    const std::string saved = desk_.save(path, litter.recipe, litter.step);
    settings_.remember(saved);
    events_.note("saved", saved);
    show(desk_.set_by_hand() ? "saved " + saved + " without what was done by hand to the checkpoint"
                             : "saved " + saved);
    return true;
  } catch (const io::Failure& failure) {
    refused(failure);
    return false;
  }
}

/// What cannot be read changes nothing.
void LiveWindow::open(const std::string& source) {
  try {
    const Opened opened = read_scene(source);
    dialogs_.cancel();
    ask_before("opening " + opened.title, [this, opened] { take(opened); });
  } catch (const io::Failure& failure) {
    refused(failure);
  }
}

/// Says it in the dialog that asked for the file, or over the arena.
void LiveWindow::refused(const io::Failure& failure) {
  dialogs_.refuse(failure.what());
  if (!dialogs_.shown()) show(failure.what());
  events_.note("refused", failure.what());
}

void LiveWindow::take(const Opened& opened) {
  desk_.take(opened);
  if (fs::path(opened.source).is_absolute()) settings_.remember(opened.source);
  controls_.params = controls_.seen = controls_.scene = opened.params;
  controls_.problem.clear();
  controls_.commands.push_back(Open{opened.params, opened.from});
  events_.note("opened", opened.source);
  show(opened.description.empty() ? "opened " + opened.title
                                  : opened.title + ": " + opened.description);
}

void LiveWindow::open_dropped(const std::string& path) {
  if (!dialogs_.shown()) controls_.open = path;
}

/// --exit-after and Ctrl-C do not come here: they ask nothing.
void LiveWindow::quit() {
  ask_before("quitting", [this] { glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE); });
}

void LiveWindow::copy_command() {
  const LitterView litter = runner_.snapshot().view();
  const std::string command = desk_.command(litter.recipe, litter.step);
  glfwSetClipboardString(window_.handle(), command.c_str());
  events_.note("copied", command);
  show("copied: " + command);
}

/// The next larger (1) or smaller (-1) size of text and widgets, or the display's (0).
void LiveWindow::resize_text(int direction) {
  const double now = static_cast<double>(gui_->scale()), little = 1e-3;
  if (direction == 0) settings_.ui_scale = 0;
  if (direction > 0) {
    const auto* next = std::ranges::upper_bound(kScales, now + little);
    settings_.ui_scale = next == std::end(kScales) ? kLargestScale : *next;
  }
  if (direction < 0) {
    const auto* next = std::ranges::lower_bound(kScales, now - little);
    settings_.ui_scale = next == std::begin(kScales) ? kSmallestScale : *(next - 1);
  }
  gui_->set_scale(settings_.ui_scale);
  schedule_.event();
}

void LiveWindow::switch_full_screen() {
  GLFWwindow* const handle = window_.handle();
  if (glfwGetWindowMonitor(handle) != nullptr) {
    const auto whole = [](float length) { return static_cast<int>(std::lround(length)); };
    glfwSetWindowMonitor(handle, nullptr, whole(windowed_.corner.x), whole(windowed_.corner.y),
                         whole(windowed_.size.x), whole(windowed_.size.y), 0);
    return;
  }
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) {
    show("there is no display to fill");
    return;
  }
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetWindowPos(handle, &x, &y);
  glfwGetWindowSize(handle, &width, &height);
  windowed_ = {{static_cast<float>(x), static_cast<float>(y)},
               {static_cast<float>(width), static_cast<float>(height)}};
  glfwSetWindowMonitor(handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

/// What the window is like now.
Settings LiveWindow::present() const {
  Settings present = settings_;
  GLFWwindow* const handle = window_.handle();
  const bool windowed = glfwGetWindowMonitor(handle) == nullptr &&
                        glfwGetWindowAttrib(handle, GLFW_MAXIMIZED) == GLFW_FALSE;
  if (windowed) glfwGetWindowSize(handle, &present.width, &present.height);
  present.quality = controls_.look.quality;
  present.draw = controls_.look.draw;
  present.panels = controls_.panels;
  present.pause_minimised = controls_.pause_minimised;
  present.colormap = controls_.look.scale.map_name;
  return present;
}

/// Takes over what the user changed, not what the command line said, and writes it; the window's
/// size, which changes often, at the end.
void LiveWindow::keep_settings() {
  const Settings now = present();
  const LitterField* const field = controls_.look.scale.field;
  const auto follow = [&](auto member, bool counts = true) {
    if (counts && now.*member != seen_.*member) settings_.*member = now.*member;
  };
  follow(&Settings::width);
  follow(&Settings::height);
  follow(&Settings::quality);
  follow(&Settings::draw);
  follow(&Settings::panels);
  follow(&Settings::pause_minimised);
  // Another field brings the map of its kind.
  follow(&Settings::colormap, field == seen_field_ && field->kind == FieldKind::continuous);
  seen_ = now;
  seen_field_ = field;
  if (controls_.recent != settings_.recent) controls_.recent = settings_.recent;
  Settings others = written_;
  if (!closing())
    std::tie(others.width, others.height) = std::pair(settings_.width, settings_.height);
  if (others == settings_) return;
  written_ = settings_;
  const std::string problem = write_settings(settings_path(), settings_);
  if (problem.empty() || std::exchange(settings_fail_, true)) return;
  io::note(problem);
  show(problem);
}

void LiveWindow::show_title() {
  const std::string title = desk_.title() + (changed() ? "*" : "") + " \u2013 pupflow";
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_.handle(), title.c_str());
  events_.note("title", title);
}

}  // namespace pupflow::window
