// Every row of the key table with real keys. A row whose action has no expectation here fails.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string>

#include "app/window/key_map.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using window::Action;
using window::key_table;
using window::KeyRow;
using window::kManySteps;

/// What xdotool calls a key.
std::string key_name(int key) {
  static const std::map<int, std::string> kNames{{GLFW_KEY_SPACE, "space"},
                                                 {GLFW_KEY_RIGHT, "Right"},
                                                 {GLFW_KEY_LEFT, "Left"},
                                                 {GLFW_KEY_HOME, "Home"},
                                                 {GLFW_KEY_ESCAPE, "Escape"},
                                                 {GLFW_KEY_TAB, "Tab"},
                                                 {'+', "plus"},
                                                 {'-', "minus"},
                                                 {GLFW_KEY_EQUAL, "equal"},
                                                 {GLFW_KEY_KP_ADD, "KP_Add"},
                                                 {GLFW_KEY_KP_SUBTRACT, "KP_Subtract"}};
  if (const auto name = kNames.find(key); name != kNames.end()) return name->second;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) {
    return "KP_" + std::to_string(key - GLFW_KEY_KP_0);
  }
  return std::string(1, static_cast<char>(std::tolower(key)));
}

std::string stroke_of(const KeyRow& row, int key) {
  return std::string(row.ctrl ? "ctrl+" : "") + (row.shift ? "shift+" : "") + key_name(key);
}

class LiveKeys : public Live {
 protected:
  using Expectation = std::function<void(const std::string& stroke)>;

  /// Presses a key after which the litter rests at another step; returns that step.
  std::int64_t go(const std::string& stroke) {
    screen_.press(stroke);
    at_ = std::stoll(await("hash "));
    for (const std::string& line : settle(kQuiet)) {  // on its way it may have rested elsewhere
      if (line.starts_with("hash ")) at_ = std::stoll(line.substr(5));
    }
    furthest_ = std::max(furthest_, at_);
    return at_;
  }

  void expect_line(const std::string& stroke, const std::string& start) {
    screen_.press(stroke);
    await(start);
  }

  void be_beyond_the_start() {
    if (at_ == 0) go("Right");
  }

  void edit(const std::string& ta) {
    click("ta-field");
    await("text on");
    type(ta);
    await("value ta " + ta);
  }

  void look_elsewhere() {
    screen_.press("Home");
    settle(kQuiet);
    expect_line(looks_from_top_ ? "y" : "t", "camera ");
    looks_from_top_ = !looks_from_top_;
  }

  std::map<Action, Expectation> expectations();

  static constexpr std::chrono::milliseconds kQuiet{300};
  std::int64_t at_ = 0, furthest_ = 0;
  bool looks_from_top_ = false;
};

std::map<Action, LiveKeys::Expectation> LiveKeys::expectations() {
  std::map<Action, Expectation> all;
  all[Action::play_pause] = [&](const std::string& stroke) {
    expect_line(stroke, "state playing");
    go(stroke);
  };
  all[Action::step] = [&](const std::string& stroke) {
    const std::int64_t before = at_;
    EXPECT_EQ(go(stroke), before + 1);
  };
  all[Action::step_many] = [&](const std::string& stroke) {
    const std::int64_t before = at_;
    EXPECT_EQ(go(stroke), before + kManySteps);
  };
  all[Action::step_back] = [&](const std::string& stroke) {
    be_beyond_the_start();
    const std::int64_t before = at_;
    EXPECT_EQ(go(stroke), before - 1);
  };
  all[Action::step_back_many] = [&](const std::string& stroke) {
    const std::int64_t before = go("shift+Right");
    EXPECT_EQ(go(stroke), before - kManySteps);
  };
  all[Action::to_start] = [&](const std::string& stroke) {
    be_beyond_the_start();
    EXPECT_EQ(go(stroke), 0);
  };
  all[Action::to_end] = [&](const std::string& stroke) {
    be_beyond_the_start();
    const std::int64_t end = furthest_;
    go("ctrl+Left");
    EXPECT_EQ(go(stroke), end);
  };
  all[Action::restart] = [&](const std::string& stroke) {
    be_beyond_the_start();
    EXPECT_EQ(go(stroke), 0);
    furthest_ = 0;
  };
  all[Action::new_seed] = [&](const std::string& stroke) {
    expect_line(stroke, "value seed ");
    at_ = std::stoll(await("hash "));
    EXPECT_EQ(at_, 0);
    furthest_ = 0;
  };
  all[Action::undo] = [&](const std::string& stroke) {
    edit("0.31");
    edit("0.32");
    expect_line(stroke, "value ta 0.31");
  };
  all[Action::redo] = [&](const std::string& stroke) {
    edit("0.33");
    edit("0.34");
    expect_line("ctrl+z", "value ta 0.33");
    expect_line(stroke, "value ta 0.34");
  };
  all[Action::faster] = [&](const std::string& stroke) {
    screen_.press("1");
    expect_line(stroke, "speed 2");
    expect_line("1", "speed 1");
  };
  all[Action::slower] = [&](const std::string& stroke) {
    screen_.press("1");
    expect_line(stroke, "speed 0.5");
    expect_line("1", "speed 1");
  };
  all[Action::real_time] = [&](const std::string& stroke) {
    expect_line("plus", "speed 2");
    expect_line(stroke, "speed 1");
  };
  all[Action::as_fast_as_possible] = [&](const std::string& stroke) {
    expect_line(stroke, "speed inf");
    expect_line(stroke, "speed 1");
  };
  all[Action::reset_camera] = [&](const std::string& stroke) {
    look_elsewhere();
    expect_line(stroke, "camera 0.523");
  };
  all[Action::top_view] = [&](const std::string& stroke) {
    screen_.press("Home");
    settle(kQuiet);
    expect_line(stroke, "camera -1.57");
  };
  all[Action::side_view] = [&](const std::string& stroke) {
    screen_.press("Home");
    settle(kQuiet);
    expect_line(stroke, "camera -1.5708 0 ");
  };
  all[Action::next_pup] = [&](const std::string& stroke) {
    screen_.press("Escape");
    expect_line(stroke, "selected 0");
    expect_line(stroke, "selected 1");
  };
  all[Action::previous_pup] = [&](const std::string& stroke) {
    screen_.press("Escape");
    expect_line("Tab", "selected 0");
    expect_line(stroke, "selected 1");
  };
  all[Action::follow_pup] = [&](const std::string& stroke) {
    screen_.press("Tab");
    expect_line(stroke, "view follow");
    expect_line(stroke, "view free");
  };
  all[Action::pups_eye] = [&](const std::string& stroke) {
    screen_.press("Tab");
    expect_line(stroke, "view eye");
    expect_line(stroke, "view free");
  };
  all[Action::screenshot] = [&](const std::string& stroke) { expect_line(stroke, "screenshot "); };
  all[Action::record] = [&](const std::string& stroke) {
    screen_.press(stroke);
    await("hash ");  // of its second frame
    expect_line(stroke, "filmed ");
    screen_.press("r");
    settle();
    at_ = furthest_ = 0;
  };
  all[Action::open] = [&](const std::string& stroke) {
    expect_line(stroke, "widget dialog-name ");
    expect_line("Escape", "gone dialog-name");
  };
  all[Action::save] = [&](const std::string& stroke) {
    expect_line(stroke, "widget dialog-name ");
    expect_line("Escape", "gone dialog-name");
  };
  all[Action::save_as] = all[Action::save];
  all[Action::copy_command] = [&](const std::string& stroke) {
    expect_line(stroke, "copied pupflow ");
  };
  all[Action::larger] = [&](const std::string& stroke) {
    const int before = widget("play").height;
    screen_.press(stroke);
    settle();
    EXPECT_GT(widget("play").height, before);
    screen_.press("ctrl+0");
    settle();
  };
  all[Action::smaller] = [&](const std::string& stroke) {
    const int before = widget("play").height;
    screen_.press(stroke);
    settle();
    EXPECT_LT(widget("play").height, before);
    screen_.press("ctrl+0");
    settle();
  };
  all[Action::usual_size] = [&](const std::string& stroke) {
    const int before = widget("play").height;
    screen_.press("ctrl+plus");
    settle();
    screen_.press(stroke);
    settle();
    EXPECT_EQ(widget("play").height, before);
  };
  all[Action::switch_theme] = [&](const std::string& stroke) {
    expect_line(stroke, "theme dark");
    expect_line(stroke, "theme light");
  };
  all[Action::full_screen] = [&](const std::string& stroke) {
    const int before = widget("play").y;
    screen_.press(stroke);
    settle();
    EXPECT_GT(widget("play").y, before) << "the screen is higher than the window was";
    screen_.press(stroke);
    settle();
    EXPECT_EQ(widget("play").y, before);
  };
  all[Action::toggle_panels] = [&](const std::string& stroke) {
    expect_line(stroke, "gone ta-field");
    expect_line(stroke, "widget ta-field ");
  };
  all[Action::toggle_help] = [&](const std::string& stroke) {
    expect_line(stroke, "help shown");
    expect_line(stroke, "help hidden");
  };
  all[Action::work_panels] = [&](const std::string& stroke) {
    screen_.press(stroke);
    settle(kQuiet);
    const std::int64_t before = at_;
    screen_.press("Right");  // moves in the panel
    screen_.press("Escape");
    settle(kQuiet);
    EXPECT_EQ(go("Right"), before + 1);
  };
  all[Action::close] = [&](const std::string& stroke) {
    expect_line("F1", "help shown");
    expect_line(stroke, "help hidden");
  };
  all[Action::quit] = [&](const std::string& stroke) {
    open({"--paused"});
    screen_.press(stroke);
    EXPECT_EQ(exit_code(), 0);
  };
  return all;
}

TEST_F(LiveKeys, EveryKeyOfTheTableDoesWhatItsRowSays) {
  const auto expected = expectations();
  open({"--paused", "--set", "pups=2", "--set", "face_points=5"},
       {"XDG_CONFIG_HOME=" + scratch_.path("settings")});
  for (const KeyRow& row : key_table()) {
    const auto expectation = expected.find(row.action);
    if (expectation == expected.end()) {
      ADD_FAILURE() << row.text << " (" << row.doc << ") has no test";
      continue;
    }
    for (const int key : row.keys) {
      if (key == 0) continue;
      SCOPED_TRACE(stroke_of(row, key) + ": " + row.doc);
      expectation->second(stroke_of(row, key));
    }
  }
}

}  // namespace
}  // namespace pupflow::testing
