// Where widgets are, at every size of window and widgets: none over another, none out of reach; what
// Esc closes; tooltips; resizing and minimising.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <string>
#include <thread>
#include <tuple>

#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

// What a finger or an unsteady hand still hits, at scale 1.
constexpr int kLeastWidth = 24, kLeastHeight = 24;

bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// Within `slack` pixels, which rounding may take.
bool within(const Box& inner, const Box& outer, int slack = 1) {
  return inner.x >= outer.x - slack && inner.y >= outer.y - slack &&
         inner.x + inner.width <= outer.x + outer.width + slack &&
         inner.y + inner.height <= outer.y + outer.height + slack;
}

std::string text(const Box& box) {
  return std::to_string(box.width) + "x" + std::to_string(box.height) + " at " +
         std::to_string(box.x) + ',' + std::to_string(box.y);
}

using Size = std::tuple<int, int>;

class LiveLayout : public Live, public ::testing::WithParamInterface<std::tuple<Size, double>> {
 protected:
  int width() const { return std::get<0>(std::get<0>(GetParam())); }
  int height() const { return std::get<1>(std::get<0>(GetParam())); }
  double scale() const { return std::get<1>(GetParam()); }

  /// Widgets are not larger than what lets the panel fit into the window.
  double shown_scale() const { return std::min(scale(), std::max(1.0, width() / 360.0)); }

  void open_here() {
    open({"--paused", "--size", std::to_string(width()) + 'x' + std::to_string(height()),
          "--ui-scale", std::to_string(scale())});
    settle();
  }

  /// Whatever the size, the lists of the colors are in reach: beside the arena, behind a button there,
  /// or in the menu.
  void open_colors() {
    if (widgets().count("colormap") > 0) return;
    if (widgets().count("overlays") > 0) {
      click("overlays");
    } else {
      if (widgets().count("menu") > 0) {
        click("menu");
        settle();
      }
      click("menu-View");
      settle();
      click("menu-overlays");
    }
    widget("colormap");
    settle();
  }

  void check_all(const std::string& when) {
    const Box window{0, 0, width(), height()};
    for (const auto& [name, widget] : widgets()) {
      const std::string what = when + ": " + name + ' ' + text(widget.box);
      EXPECT_TRUE(within(widget.shown, window)) << what << " in a panel " << text(widget.shown);
      Box reach = widget.shown;
      if (widget.scrolls) {  // up and down
        reach.y = widget.box.y;
        reach.height = widget.box.height;
      }
      EXPECT_TRUE(within(widget.box, reach)) << what << " in a panel " << text(widget.shown);
      EXPECT_GE(widget.box.width, static_cast<int>(kLeastWidth * shown_scale()) - 1) << what;
      EXPECT_GE(widget.box.height, static_cast<int>(kLeastHeight * shown_scale()) - 1) << what;
      for (const auto& [other_name, other] : widgets()) {
        if (other_name <= name || other.panel != widget.panel) continue;
        EXPECT_FALSE(overlap(widget.box, other.box))
            << what << " and " << other_name << ' ' << text(other.box);
      }
    }
  }
};

TEST_P(LiveLayout, WidgetsAreInReachAndApart) {
  open_here();
  for (const char* name : {"play", "step", "restart", "panels"}) {
    EXPECT_EQ(widgets().count(name), 1u) << name << " is in sight from the start";
  }
  check_all("at first");
  const bool drawer = widgets().count("ta") == 0;
  if (drawer) {
    click("panels");
    await("widget ta ");
    settle();
    check_all("with the drawer open");
    EXPECT_EQ(widgets().count("panels"), 1u) << "the button that closes it";
    screen_.press("Escape");
    await("gone ta");
  }
  open_colors();
  check_all("with the lists of the colors");
  // Away from the menus first: one that the mouse rests on opens again.
  screen_.hand({"mousemove", "1", std::to_string(height() - 2), "sleep", "0.3"});
  for (int i = 0; i < 4; ++i) screen_.hand({"key", "Escape", "sleep", "0.3"});
  settle();
  screen_.press("F1");
  await("widget close_help ");
  settle();
  EXPECT_TRUE(within(widget("close_help"), {0, 0, width(), height()}));
  click("close_help");
  await("help hidden");
}

std::string size_name(const ::testing::TestParamInfo<std::tuple<Size, double>>& test) {
  const Size& size = std::get<0>(test.param);
  const int tenths = static_cast<int>(10 * std::get<1>(test.param));
  return std::to_string(std::get<0>(size)) + "x" + std::to_string(std::get<1>(size)) + "_scale_" +
         std::to_string(tenths) + "_tenths";
}

INSTANTIATE_TEST_SUITE_P(Sizes, LiveLayout,
                         ::testing::Combine(::testing::Values(Size{1400, 900}, Size{1280, 800},
                                                              Size{800, 600}, Size{360, 300}),
                                            ::testing::Values(1.0, 1.5, 2.0)),
                         size_name);

TEST_F(Live, EscapeClosesAListAndNeverQuits) {
  open({"--paused"});
  click("contact");
  settle();
  screen_.press("Escape");
  settle();
  click("ta-field");  // with the list open, this would only close it
  await("text on");
  screen_.press("Escape");
  await("text off");
  for (int i = 0; i < 3; ++i) screen_.press("Escape");
  screen_.press("Right");
  EXPECT_EQ(await("step "), "1") << "the window is still there";
}

TEST_F(Live, EscapeClosesAMenuAndEndsTyping) {
  open({"--paused"});
  click("menu-Run");
  await("widget pause_minimised ");
  screen_.press("Escape");
  await("gone pause_minimised");
  click("seed");
  await("text on");
  screen_.press("Escape");
  await("text off");
  screen_.press("Right");
  EXPECT_EQ(await("step "), "1") << "the window is still there";
}

TEST_F(Live, KeysWorkThePanelsOnlyWhenAskedTo) {
  open({"--paused", "--set", "ta=0.4"});
  screen_.press("Right");
  EXPECT_EQ(await("step "), "1") << "an arrow steps";
  screen_.press("F6");
  settle();
  screen_.press("Right");   // from the slider to its field
  screen_.press("Return");  // types there
  await("text on");
  type("0.31");
  EXPECT_EQ(await("value ta "), "0.31");
  screen_.press("Down");
  screen_.press("Escape");
  settle();
  screen_.press("Right");
  EXPECT_EQ(await("step "), "2") << "and steps again, once; moving in the panel did not";
}

TEST_F(Live, ATooltipWaitsAndStandsBesideTheArena) {
  open({"--paused"});
  const Box ta = widget("ta");
  const int arena = widget("play").x;
  const auto rest_at = [&](int x, int y) {
    screen_.hand({"mousemove", std::to_string(x), std::to_string(y)});
  };
  rest_at(ta.middle_x(), ta.middle_y());
  std::istringstream place(await("tip "));
  Box tip;
  ASSERT_TRUE(place >> tip.x >> tip.y >> tip.width >> tip.height);
  EXPECT_LE(tip.x + tip.width, arena);
  EXPECT_FALSE(overlap(tip, ta));
  rest_at(ta.middle_x(), ta.y + 400);
  while (await("tip ") != "none") {
  }
}

TEST_F(Live, ATooltipStaysAwayAfterADrag) {
  open({"--paused", "--set", "ta=0.4"});
  const Box ta = widget("ta");
  screen_.press_and_move(ta.x + 2 * ta.width / 5, ta.middle_y(), ta.middle_x(), ta.middle_y());
  await("value ta ");
  screen_.release();
  const auto until = std::chrono::steady_clock::now() + milliseconds(1500);
  while (std::chrono::steady_clock::now() < until) {
    const auto line = window_->read_line(milliseconds(200));
    EXPECT_THAT(line.value_or(""), ::testing::Not(::testing::StartsWith("tip")));
  }
  screen_.hand({"mousemove", "700", "300", "sleep", "0.3", "mousemove",
                std::to_string(ta.middle_x()), std::to_string(ta.middle_y())});
  EXPECT_NE(await("tip "), "none") << "once the mouse has been elsewhere";
}

/// The distance of the camera that a `camera` line says.
double distance_in(const std::string& camera) {
  return std::stod(camera.substr(camera.rfind(' ')));
}

TEST_F(Live, AfterAResizeTheArenaIsFramedAnew) {
  open({"--paused", "--size", "1000x700"});
  settle();
  screen_.hand({"search", "--name", "pupflow", "windowsize", "1000", "400"});
  const double low = distance_in(await("camera "));
  screen_.hand({"search", "--name", "pupflow", "windowsize", "1000", "700"});
  double high = low;
  while (high <= low) high = distance_in(await("camera "));
  EXPECT_GT(high, low) << "the higher a picture, the further away an arena that fills its width";
}

TEST_F(Live, StandsWhenTheWindowGrowsAndShrinks) {
  open({"--paused", "--size", "700x500"});
  int step = 0;
  for (const auto& [width, height] : {std::pair{"1400", "950"}, {"600", "400"}, {"900", "900"}}) {
    screen_.hand({"search", "--onlyvisible", "--name", "pupflow", "windowsize", width, height});
    settle();
    screen_.press("Right");
    EXPECT_EQ(await("step "), std::to_string(++step)) << window_->errors();
  }
}

TEST_F(Live, AMinimisedWindowGoesOnSteppingUnlessToldNotTo) {
  open({"--set", "pups=2"});
  const auto steps_while_away = [&] {
    screen_.hand({"search", "--name", "pupflow", "windowunmap"});
    await("visible no");
    settle(milliseconds(100));
    std::this_thread::sleep_for(milliseconds(2500));
    const auto none = window_->read_line(milliseconds(0));
    EXPECT_FALSE(none) << "nothing is drawn: " << *none;
    screen_.hand({"search", "--name", "pupflow", "windowmap"});
    await("visible yes");
    return std::stoll(await("step "));
  };
  const std::int64_t before = std::stoll(await("step "));
  const std::int64_t after = steps_while_away();
  EXPECT_GT(after, before + 150) << "2.5 seconds of 100 steps each";

  click("menu-Run");
  click("pause_minimised");
  await("gone pause_minimised");
  settle(milliseconds(100));
  const std::int64_t left_at = std::stoll(await("step "));
  EXPECT_LT(steps_while_away(), left_at + 150);
}

TEST_F(Live, ATallColumnOffersACarpet) {
  open({"--paused", "--set", "pups=120"});
  click("carpet");
  EXPECT_EQ(await("value start "), "carpet");
  await("gone carpet");
}

TEST_F(Live, ABadStateShowsItsPup) {
  open({"--set", "heat=euler", "--set", "k1=210", "--set", "pups=2"});
  const std::string message = await("bad ");
  EXPECT_THAT(message, HasSubstr("pup "));
  click("bad_show");
  settle();
  screen_.press("Escape");  // lets go of the pup
  click("bad_restart");
  await("state playing");  // it ran, so it runs again
}

}  // namespace
}  // namespace pupflow::testing
