// Random clicks and keys. The seed and the length are PUPFLOW_SOAK_SEED and PUPFLOW_SOAK_SECONDS.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "app/io/params_of_file.h"
#include "app/io/png.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr double kSeconds = 15;       // unless told otherwise
constexpr long kMostMegabytes = 900;  // snapshots to go back to, and all of llvmpipe
constexpr double kLong = 300;         // seconds after half of which memory grows no more
constexpr long kMostGrowth = 60;      // megabytes
constexpr int kWidth = 1000, kHeight = 700, kMenuHeight = 30;

/// What leads to files of the machine that the test runs on, or quits.
bool opens_files(const std::string& widget) {
  return widget.starts_with("menu-Scene") || widget.starts_with("dialog");
}

// What does not quit. Files are written to the test's folder only.
const std::vector<std::string> kKeys{
    "space", "Right", "Left",   "shift+Right", "shift+Left", "ctrl+Left", "ctrl+Right", "r",
    "plus",  "minus", "1",      "f",           "Home",       "t",         "y",          "Tab",
    "l",     "e",     "h",      "F1",          "F6",         "Escape",    "ctrl+z",     "ctrl+y",
    "Down",  "Up",    "Return", "shift+r",     "ctrl+plus",  "ctrl+0",    "ctrl+d"};

double number_of(const char* variable, double otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::stod(text);
}

/// Memory of a process that is in the machine's own.
long megabytes_of(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string word;
  long kilobytes = 0;
  while (status >> word) {
    if (word == "VmRSS:") status >> kilobytes;
  }
  return kilobytes / 1024;
}

class LiveSoak : public Live {
 protected:
  int up_to(int end) { return std::uniform_int_distribution(0, end - 1)(random_); }

  /// One thing that a hand may do: on a widget, anywhere, or on the keyboard.
  void do_something() {
    const std::string x = std::to_string(up_to(kWidth));
    const std::string y = std::to_string(kMenuHeight + up_to(kHeight - kMenuHeight));
    switch (up_to(6)) {
      case 0:
      case 1:
        if (!widgets().empty()) {
          const auto any = std::next(widgets().begin(), up_to(static_cast<int>(widgets().size())));
          const Box& box = any->second.box;
          if (!opens_files(any->first)) {
            const int at = box.x + up_to(std::max(box.width, 1));
            screen_.hand({"mousemove", std::to_string(std::max(at, 0)),
                          std::to_string(std::max(box.middle_y(), 0)), "click",
                          up_to(8) == 0 ? "3" : "1"});
          }
        }
        break;
      case 2:
        screen_.hand({"mousemove", x, y, "click", std::to_string(1 + up_to(5))});
        break;
      case 3:
        screen_.hand({"mousemove", x, y, "mousedown", "1", "mousemove",
                      std::to_string(up_to(kWidth)), y, "mouseup", "1"});
        break;
      default:
        screen_.press(kKeys[static_cast<std::size_t>(up_to(static_cast<int>(kKeys.size())))]);
    }
    settle(milliseconds(20));
  }

  /// Back to where keys do what their table says.
  void close_everything() {
    for (int i = 0; i < 8; ++i) screen_.press("Escape");
    settle();
  }

  std::mt19937 random_;
};

TEST_F(LiveSoak, RandomClicksAndKeysLoseNothing) {
  const auto seed = static_cast<unsigned>(number_of("PUPFLOW_SOAK_SEED", 7));
  const double seconds = number_of("PUPFLOW_SOAK_SECONDS", kSeconds);
  SCOPED_TRACE("PUPFLOW_SOAK_SEED=" + std::to_string(seed));
  random_.seed(seed);
  open({"--size", std::to_string(kWidth) + 'x' + std::to_string(kHeight), "--out", "soak-%d.png",
        "--set", "face_points=5"},
       {"XDG_CONFIG_HOME=" + scratch_.path("settings")});
  long most = 0, most_before = 0;  // in the second half of the time, and in the first
  const auto begun = Clock::now();
  const auto end = begun + std::chrono::duration<double>(seconds);
  while (Clock::now() < end && !HasFailure()) {
    do_something();
    const long megabytes = megabytes_of(window_->pid());
    ASSERT_GT(megabytes, 0) << "the window is gone: " << window_->errors();
    const bool early = Clock::now() - begun < std::chrono::duration<double>(seconds / 2);
    (early ? most_before : most) = std::max(early ? most_before : most, megabytes);
  }
  if (seconds >= kLong) {
    EXPECT_LT(most, most_before + kMostGrowth) << "megabytes";
  }
  EXPECT_LT(most, kMostMegabytes) << "megabytes";
  RecordProperty("megabytes", static_cast<int>(most));
  RecordProperty("megabytes_before", static_cast<int>(most_before));

  // What was done by then, and one edit more, is in the recipe that a picture carries.
  close_everything();
  screen_.press("r");
  screen_.press("shift+Right");
  settle();
  screen_.press("s");
  const std::string path = scratch_.path(await("screenshot "));
  const Params recipe = io::params_of_file(path);
  std::string hash;
  std::int64_t step = 0;
  for (const auto& [key, value] : io::read_png_text(path)) {
    if (key == "hash") hash = value;
    if (key == "step") step = std::stoll(value);
  }
  EXPECT_EQ(std::stoull(hash, nullptr, 16), std::stoull(headless_hash(recipe, step), nullptr, 16));
  screen_.press("q");
  settle();
  if (widgets().count("dialog-discard") > 0) click("dialog-discard");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_EQ(window_->errors(), "");
}

}  // namespace
}  // namespace pupflow::testing
