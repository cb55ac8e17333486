// The plots as somebody at the screen meets them.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/io/csv.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

class LivePlots : public Live {
 protected:
  /// Moves the mouse over a plot, `share` of its width from the left, and returns the time there.
  double point_at(const std::string& plot, double share) {
    const Box box = widget(plot);
    const int x = box.x + static_cast<int>(share * box.width);
    screen_.hand({"mousemove", std::to_string(x), std::to_string(box.middle_y())});
    return pointed();
  }

  double pointed() {
    std::string text = "nowhere";
    while (text == "nowhere") text = await("pointed ");
    return std::stod(text);
  }

  void leave_plots() {
    screen_.hand({"mousemove", "700", "300"});
    while (await("pointed ") != "nowhere") continue;
  }
};

TEST_F(LivePlots, AllPlotsShareATimeUnderTheMouse) {
  open({"--paused"});
  const double left = point_at("plot-mean_tb", 0.3);
  EXPECT_GT(point_at("plot-mean_tb", 0.8), left);
  leave_plots();
  const double below = point_at("plot-flow", 0.3);
  EXPECT_NEAR(below, left, 0.2);
  leave_plots();
}

TEST_F(LivePlots, TheirSpanIsChosenFromAList) {
  open({"--paused"});
  click("plots-span");
  click("plots-span-3");
  await("plots-span 5 min");
  const Box box = widget("plot-groups");
  const std::string x = std::to_string(box.x + 9 * box.width / 10);
  screen_.hand({"mousemove", x, std::to_string(box.middle_y())});
  double time = 0;
  while (time < 200) time = pointed();
  EXPECT_LT(time, 300);
}

TEST_F(LivePlots, WhatTheyShowIsSavedAsCsv) {
  Params params;
  params.ambient_temperature = 0.3;
  open({"--set", "ta=0.3"});
  while (std::stoll(await("step ")) < 30) continue;
  screen_.press("space");
  await("state paused");
  click("plots-csv");
  click("plots-save");
  const std::string path = scratch_.path(await("saved "));
  ASSERT_TRUE(std::filesystem::exists(path)) << path;

  io::CsvReader file(path);
  Simulation simulation(params);
  simulation.set_observed(ObservableSet::all().parts());
  Observer observer(simulation);
  int rows = 0;
  const std::size_t columns = io::metrics_columns().size();
  for (auto row = file.next(); row; row = file.next(), ++rows) {
    while (std::to_string(simulation.steps_done()) != row->front()) {
      ASSERT_TRUE(simulation.step().ok());
      ASSERT_LT(simulation.steps_done(), 100'000);
      observer.observe(simulation);
    }
    if (rows == 0) continue;  // the window may not know the flow yet
    const auto expected =
        io::metrics_cells(simulation.steps_done(), simulation.time(), observer.last());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), row->begin()))
        << "step " << row->front();
  }
  EXPECT_GT(rows, 20);
  EXPECT_GT(file.columns().size(), columns);
}

TEST_F(LivePlots, ThePhasePlotTellsOfTheStepUnderTheMouse) {
  open({"--paused", "--size", "1400x900"});
  screen_.press("shift+n");
  await("hash 100 ");
  click("plots");
  await("widget phase ");
  click("phase");
  const Box plot = widget("phase-plot");
  // T_a is 0.5 all along: one of these lies near the middle of the plot's paper.
  for (int x = plot.middle_x(); x < plot.x + plot.width * 2 / 3; x += 8) {
    for (int y = plot.y + 20; y < plot.y + plot.height; y += 12) {
      screen_.hand({"mousemove", std::to_string(x), std::to_string(y)});
      while (const auto line = window_->read_line(std::chrono::milliseconds(60))) {
        if (line->starts_with("phase at ")) return;
      }
    }
  }
  FAIL() << "no place of the plot told of a step";
}

TEST_F(LivePlots, PhasePlotAndHistogramsOpen) {
  open({"--paused", "--size", "1400x900"});
  click("plots");
  await("widget phase ");  // it moved up
  click("phase");
  EXPECT_GT(widget("phase-plot").height, 100);
  await("widget histograms ");
  click("histograms");
  EXPECT_GT(widget("histogram-tb").width, 100);
  EXPECT_GT(widget("histogram-groups").width, 100);
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
}

}  // namespace
}  // namespace pupflow::testing
