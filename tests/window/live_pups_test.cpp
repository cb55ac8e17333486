// Pups in the live window: selected by mouse and keys, followed, inspected, pulled.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <sstream>

#include "app/io/png.h"
#include "app/view/framing.h"
#include "app/view/marks.h"
#include "pupflow/fields.h"
#include "pupflow/simulation.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using ::testing::HasSubstr;

constexpr int kSteps = 100;

class LivePups : public Live {
 protected:
  /// A paused litter, kSteps after its start, seen from above.
  void open_litter(std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--paused", "--seed", "3", "--set", "start=carpet"});
    open(options);
    screen_.press("shift+n");
    await("hash " + std::to_string(kSteps) + ' ');
    screen_.press("t");
    while (!await("camera ").starts_with("-1.57")) {
    }
  }

  /// The same litter without a window.
  static Simulation litter() {
    Params params;
    params.seed = 3;
    params.start = Start::carpet;
    Simulation simulation(params);
    simulation.set_observed(PartSet::all());
    simulation.run(kSteps);
    return simulation;
  }

  /// Where a place of the arena is on the screen, seen from above.
  std::pair<int, int> on_screen(const Eigen::Vector3d& place, const Params& params) {
    return on_screen(place, params, widget("arena"));
  }

  static std::pair<int, int> on_screen(const Eigen::Vector3d& place, const Params& params,
                                       const Box& arena) {
    const view::Camera camera = view::framed(view::Camera::parse("top"), params,
                                             static_cast<double>(arena.width) / arena.height);
    const view::Projection projection(camera, {{-3, -3, -1}, {3, 3, 3}}, arena.width, arena.height);
    Eigen::Vector2d pixels;
    EXPECT_TRUE(projection.place(place, pixels));
    return {arena.x + static_cast<int>(pixels.x()), arena.y + static_cast<int>(pixels.y())};
  }

  void click_at(std::pair<int, int> place) { screen_.click(place.first, place.second); }

  /// A pup over which no other lies.
  static int one_on_top(const LitterView& litter) {
    int top = 0;
    for (int pup = 1; pup < litter.pups; ++pup) {
      if (litter.positions.mean(pup).z() > litter.positions.mean(top).z()) top = pup;
    }
    return top;
  }
};

TEST_F(LivePups, AClickSelectsAPupAndAClickBesideItNone) {
  open_litter();
  const Simulation simulation = litter();
  const int pup = one_on_top(simulation);
  click_at(on_screen(simulation.view().positions.mean(pup), simulation.params()));
  EXPECT_EQ(await("selected "), std::to_string(pup));
  click_at(on_screen({-1.9, -1.9, 0}, simulation.params()));
  EXPECT_EQ(await("selected "), "none");
}

TEST_F(LivePups, AClickInEitherArenaOfAComparisonSelects) {
  open_litter();
  click("compare");
  click("compare-value");
  await("text on");
  type("0.1");
  click("compare-start");
  await("second ");
  settle();
  Params params = litter().params();
  const Simulation start(params);  // both begin anew
  const Box arena = widget("arena");
  Box half = arena;
  if (arena.width >= arena.height) {
    half.width /= 2;
    half.x += half.width;
  } else {
    half.height /= 2;
    half.y += half.height;
  }
  click_at(on_screen(start.view().positions.mean(5), params, half));
  EXPECT_EQ(await("selected "), "5");
  half.x = arena.x;
  half.y = arena.y;
  click_at(on_screen(start.view().positions.mean(7), params, half));
  EXPECT_EQ(await("selected "), "7");
}

TEST_F(LivePups, APictureHasTheRingOfTheSelectedPup) {
  open_litter({"--out", "shot.png"});
  const auto picture = [&] {
    screen_.press("s");
    return io::read_png(scratch_.path(await("screenshot ")));
  };
  const io::Image without = picture();
  screen_.press("Tab");
  await("selected 0");
  EXPECT_FALSE(picture().rgba == without.rgba);
  screen_.press("Escape");
  await("selected none");
  EXPECT_TRUE(picture().rgba == without.rgba);
}

TEST_F(LivePups, ADragOverAPupTurnsTheViewAndSelectsNone) {
  open_litter();
  const Simulation simulation = litter();
  const auto [x, y] =
      on_screen(simulation.view().positions.mean(one_on_top(simulation)), simulation.params());
  screen_.press_and_move(x, y, x + 60, y);
  await("camera ");
  screen_.release();
  screen_.press("Tab");
  EXPECT_EQ(await("selected "), "0") << "the first selection";
}

TEST_F(LivePups, TabAndTheInspectorsButtonsGoThroughThePups) {
  open_litter();
  screen_.press("Tab");
  EXPECT_EQ(await("selected "), "0");
  screen_.press("shift+Tab");
  EXPECT_EQ(await("selected "), "11");
  screen_.press("Tab");
  EXPECT_EQ(await("selected "), "0");
  click("pup_next");
  EXPECT_EQ(await("selected "), "1");
}

TEST_F(LivePups, TheInspectorShowsEveryFieldOfThePup) {
  open_litter();
  screen_.press("Tab");
  screen_.hand({"sleep", "0.5"});
  screen_.press("n");  // whatever was not recorded before is now
  std::map<std::string, std::string> shown;
  bool stepped = false;
  while (const auto line = window_->read_line(std::chrono::seconds(stepped ? 2 : 20))) {
    std::istringstream words(*line);
    std::string kind, name, text;
    words >> kind >> name >> text;
    stepped = stepped || line->starts_with("hash 101 ");
    if (kind == "field") shown[name] = text;
  }
  ASSERT_TRUE(stepped);
  Simulation simulation = litter();
  simulation.step();
  for (const LitterField& field : pup_fields()) {
    const std::string name(field.name);
    ASSERT_EQ(shown.count(name), 1u) << name;
    // The window has points as float.
    EXPECT_NEAR(std::stod(shown[name]), field.values(simulation)[0], 2e-3) << name;
  }
}

TEST_F(LivePups, TheSkinTellsOfTheAfferentUnderTheMouse) {
  open_litter();
  screen_.press("Tab");
  for (const char* map : {"disc", "cross"}) {
    const Box skin = widget(map);
    screen_.hand({"mousemove", std::to_string(skin.middle_x()), std::to_string(skin.middle_y())});
    while (await("tip ") == "none") {
    }
    screen_.hand({"mousemove", "700", "450"});
    while (await("tip ") != "none") {
    }
  }
}

TEST_F(LivePups, AClickOnATouchedAfferentSelectsThePupThatTouchesIt) {
  // Two pups that lie on each other: from every side one touches the other somewhere.
  open({"--paused", "--set", "pups=2", "--set", "start_spread=0"});
  screen_.press("shift+n");
  await("hash 100 ");
  screen_.press("Tab");
  ASSERT_EQ(await("selected "), "0");
  const Box skin = widget("cross");
  constexpr int kColumns = 24;
  for (int i = 0; i < kColumns * kColumns; ++i) {
    const int x = skin.x + (2 * (i % kColumns) + 1) * skin.width / (2 * kColumns);
    const int y = skin.y + (2 * (i / kColumns) + 1) * skin.height / (2 * kColumns);
    screen_.click(x, y);
    while (const auto line = window_->read_line(std::chrono::milliseconds(30))) {
      if (*line == "selected 1") return;
    }
  }
  FAIL() << "no afferent was touched";
}

TEST_F(LivePups, ADoubleClickFollowsSoThatThePupIsInTheMiddle) {
  open_litter();
  const Simulation simulation = litter();
  const int pup = one_on_top(simulation);
  const auto place = on_screen(simulation.view().positions.mean(pup), simulation.params());
  screen_.hand({"mousemove", std::to_string(place.first), std::to_string(place.second), "sleep",
                "0.1", "click", "--repeat", "2", "--delay", "120", "1"});
  EXPECT_EQ(await("selected "), std::to_string(pup));
  EXPECT_EQ(await("view "), "follow");
  screen_.press("l");
  EXPECT_EQ(await("view "), "free");
  screen_.press("Tab");
  EXPECT_EQ(await("selected "), std::to_string((pup + 1) % 12));
  const Box arena = widget("arena");
  screen_.click(arena.middle_x(), arena.middle_y());
  EXPECT_EQ(await("selected "), std::to_string(pup)) << "the camera is still where it led";
}

TEST_F(LivePups, ThePupsEyeLooksAlongItsHeadingAndEndsWhereItBegan) {
  open_litter();
  const Simulation simulation = litter();
  screen_.press("Tab");
  await("selected 0");
  screen_.press("e");
  EXPECT_EQ(await("view "), "eye");
  const double heading = simulation.view().heading[0];
  std::istringstream line(await("camera "));
  double azimuth = 0, elevation = 1;
  line >> azimuth >> elevation;
  EXPECT_NEAR(std::remainder(azimuth - heading - M_PI, 2 * M_PI), 0, 1e-4);
  EXPECT_EQ(elevation, 0);
  screen_.press("e");
  EXPECT_EQ(await("view "), "free");
  EXPECT_THAT(await("camera "), HasSubstr("-1.57"));
}

TEST_F(LivePups, CtrlAndADragPullAPup) {
  open_litter();
  const Simulation simulation = litter();
  const int pup = one_on_top(simulation);
  const Eigen::Vector3d from = simulation.view().positions.mean(pup);
  const auto [x, y] = on_screen(from, simulation.params());
  screen_.hand({"keydown", "Control_L"});
  screen_.press_and_move(x, y, x + 50, y);
  EXPECT_EQ(await("selected "), std::to_string(pup));
  screen_.hand({"keyup", "Control_L"});
  // Only the pull is the difference: a step of the same litter without one.
  Simulation free = simulation;
  free.step();
  std::ostringstream hash;
  hash << std::hex << free.hash();
  screen_.press("n");
  EXPECT_NE(await("hash 101 "), hash.str());
  screen_.release();
}

}  // namespace
}  // namespace pupflow::testing
