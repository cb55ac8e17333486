#include "app/io/settings.h"

#include <gmock/gmock.h>

#include "app/io/csv.h"
#include "failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using test::failure_of;
using testing::HasSubstr;

TEST(Settings, LaterSourcesWin) {
  const test::Scratch scratch;
  Settings settings;
  settings.scene = scratch.file("s.toml", "title = 'S'\nta = 0.1\ntp = 0.1\nseed = 2\nsteps = 2\n");
  settings.sets = {"tp=0.2", "seed=3", "g=7", "g=8"};
  settings.seed = "4";
  settings.precision = "float";
  const io::Setup setup = set_up(settings);
  Params expected;
  expected.ambient_temperature = 0.1;    // the scene's
  expected.preferred_temperature = 0.2;  // --set over the scene
  expected.thermogenesis = 8;            // the last --set
  expected.seed = 4;                     // --seed over --set
  expected.steps = 2;                    // the scene's
  expected.precision = Precision::float_;
  EXPECT_EQ(setup.params, expected);
  EXPECT_EQ(setup.title, "S");
}

TEST(Settings, LikeTakesAllParametersOfAFile) {
  const test::Scratch scratch;
  Params params;
  params.ambient_temperature = 0.123456789012345678;
  params.seed = 77;
  MetricsCsv(scratch.path("m.csv"), false, Simulation(params)).file().commit();
  Settings settings;
  settings.like = scratch.path("m.csv");
  EXPECT_EQ(set_up(settings).params, params);
  settings.sets = {"seed=5"};
  params.seed = 5;
  EXPECT_EQ(set_up(settings).params, params);
  settings.scene = "cold";
  failure_of(ExitCode::bad_input, [&] { set_up(settings); });
}

TEST(Settings, ListsAllProblemsOfAllSources) {
  const test::Scratch scratch;
  Settings settings;
  settings.scene = scratch.file("s.toml", "alpha = 3\narena_radius = 0.1\n");
  settings.sets = {"bta=1", "pups", "k1=-1"};
  settings.seed = "x";
  const std::string message = failure_of(ExitCode::bad_input, [&] { set_up(settings); });
  for (const char* part : {"s.toml:1:9: alpha = 3", "unknown parameter 'bta'; did you mean 'beta'?",
                           "--set 'pups': must be name=value", "--set: k1 = -1",
                           "--seed: seed = 'x'", "arena radius must exceed"}) {
    EXPECT_THAT(message, HasSubstr(part));
  }
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 5);
}

}  // namespace
}  // namespace pupflow::io
