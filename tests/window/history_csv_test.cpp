#include "app/window/history_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "pupflow/observer.h"
#include "tests/support/scratch.h"

namespace pupflow::window {
namespace {

/// A session that was watched for so many steps.
LiveState watched(const Params& params, int steps) {
  Session session(params, true);
  for (int i = 0; i < steps; ++i) session.step();
  LiveState state;
  session.fill(state);
  return state;
}

Params small_litter() {
  Params params;
  params.pups = 4;
  params.face_points = 3;
  params.seed = 5;
  return params;
}

TEST(HistoryCsv, ReadsBackAsWhatASimulationWithoutAWindowGives) {
  const test::Scratch scratch;
  const Params params = small_litter();
  const LiveState state = watched(params, 40);
  const std::string path =
      save_history_csv(scratch.path("seen-%03d.png"), state, StepRange{11, 40});
  EXPECT_EQ(path, scratch.path("seen-040.csv"));

  EXPECT_EQ(io::params_from(io::read_csv_header(path), path), params);
  io::CsvReader file(path);
  const std::vector<std::string> expected = io::metrics_columns();
  ASSERT_GT(file.columns().size(), expected.size());
  Simulation simulation(params);
  simulation.set_observed(ObservableSet::all().parts());
  Observer observer(simulation);
  for (int step = 1; step <= 40; ++step) {
    simulation.step();
    const Observables seen = observer.observe(simulation);
    if (step < 11) continue;
    const auto row = file.next();
    ASSERT_TRUE(row);
    const auto cells = io::metrics_cells(step, simulation.time(), seen);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      EXPECT_EQ(file.columns()[i], expected[i]);
      EXPECT_EQ((*row)[i], cells[i]) << expected[i] << " after step " << step;
    }
    EXPECT_EQ(row->back(), "1") << "a row a step";
    const auto tb = simulation.view().tb;
    EXPECT_EQ((*row)[cells.size()], io::number_text(*std::min_element(tb.begin(), tb.end())));
  }
  EXPECT_FALSE(file.next());
}

TEST(HistoryCsv, OverwritesNothing) {
  const test::Scratch scratch;
  const LiveState state = watched(small_litter(), 3);
  const StepRange all{1, 3};
  const std::string first = save_history_csv(scratch.path("a-%d"), state, all);
  const std::string second = save_history_csv(scratch.path("a-%d"), state, all);
  EXPECT_NE(first, second);
  EXPECT_TRUE(std::filesystem::exists(first));
  EXPECT_TRUE(std::filesystem::exists(second));
}

TEST(HistoryCsv, SaysWhereItCannotBeWritten) {
  const test::Scratch scratch;
  const LiveState state = watched(small_litter(), 3);
  EXPECT_THROW(save_history_csv(scratch.path("none/a-%d"), state, {1, 3}), io::Failure);
}

}  // namespace
}  // namespace pupflow::window
