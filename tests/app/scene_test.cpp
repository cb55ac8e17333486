#include "app/io/scene_file.h"

#include <gmock/gmock.h>

#include "failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using test::failure_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> problems_of(const std::string& text) {
  std::vector<std::string> problems;
  parse_scene(text, "s.toml", problems);
  return problems;
}

TEST(Scene, SetsWhatItNamesAndNothingElse) {
  std::vector<std::string> problems;
  const Scene scene = parse_scene(
      "title = 'A'\ndescription = 'B'\nta = 1\nseed = 9007199254740991\nheat = 'euler'\n", "s.toml",
      problems);
  EXPECT_THAT(problems, IsEmpty());
  Params expected;
  expected.ambient_temperature = 1;
  expected.seed = 9007199254740991;
  expected.heat = HeatRule::euler;
  EXPECT_EQ(scene.params, expected);
  EXPECT_EQ(scene.title, "A");
  EXPECT_EQ(scene.description, "B");
}

TEST(Scene, ListsEveryProblemWithItsPlaceFromTopToBottom) {
  const auto problems = problems_of(
      "ta = 0.2\n"
      "  alpa = 1\n"
      "pups = 2.0\n"
      "heading = 'boddy'\n"
      "beta = 7\n"
      "drive = 'x'\n"
      "seed = 99999999999999999\n"
      "title = 3\n"
      "[extra]\n");
  EXPECT_THAT(problems, ElementsAre("s.toml:2:3: unknown key 'alpa'; did you mean 'alpha'?",
                                    StartsWith("s.toml:3:8: pups must be a whole number"),
                                    StartsWith("s.toml:4:11: heading = 'boddy'"),
                                    StartsWith("s.toml:5:8: beta = 7"),
                                    StartsWith("s.toml:6:9: drive must be a number, not a string"),
                                    StartsWith("s.toml:7:8: seed = 1e+17"),
                                    StartsWith("s.toml:8:1: title must be a string"),
                                    StartsWith("s.toml:9:2: 'extra' is a table")));
}

TEST(Scene, PlacesAnErrorOfTheToml) {
  EXPECT_THAT(problems_of("ta = 0.2\nta = 0.3\n"), ElementsAre(StartsWith("s.toml:2:")));
  EXPECT_THAT(problems_of("pups = 3\nta = \n"), ElementsAre(StartsWith("s.toml:2:")));
  EXPECT_THAT(problems_of("ta = inf"), ElementsAre(StartsWith("s.toml:1:6: ta = inf")));
  EXPECT_THAT(problems_of("g = nan"), ElementsAre(StartsWith("s.toml:1:5: g = nan")));
}

TEST(Scene, ShippedOnesAreSoundAndDescribed) {
  EXPECT_GE(shipped_scenes().size(), 10U);
  for (const ShippedScene& shipped : shipped_scenes()) {
    std::vector<std::string> problems;
    const Scene scene = load_scene(std::string(shipped.name), problems);
    EXPECT_THAT(problems, IsEmpty()) << shipped.name;
    EXPECT_THAT(check(scene.params), IsEmpty()) << shipped.name;
    EXPECT_FALSE(scene.title.empty()) << shipped.name;
    EXPECT_FALSE(scene.description.empty()) << shipped.name;
  }
}

TEST(Scene, OnlyKeysOfManyPartsAreTooDeep) {
  std::string dots = "title = \"";
  for (int i = 0; i < 100; ++i) dots += ".a";
  const std::string text = dots + "\" # " + dots + "\ndescription = \"\"\"a \\\" " + dots +
                           "\n ... \"\"\"\"\nta = 0.25 # it's " + dots + "\ntp = 0.5\n";
  std::vector<std::string> problems;
  const Scene scene = parse_scene(text, "a.toml", problems);
  EXPECT_THAT(problems, IsEmpty());
  EXPECT_EQ(scene.params.preferred_temperature, 0.5);
  std::string key = "b";
  for (int i = 0; i < 32; ++i) key += i % 2 == 0 ? ".\"]=\"" : " . 'it'";
  parse_scene("ta = 1\n " + key + " = 2\n", "a.toml", problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_THAT(problems[0], AllOf(StartsWith("a.toml:2:"), HasSubstr("more than 32 parts")));
}

TEST(Scene, UnknownNameGetsTheNearestOrAllShippedOnes) {
  std::vector<std::string> problems;
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { load_scene("colt", problems); }),
              HasSubstr("did you mean 'cold'?"));
  const std::string message =
      failure_of(ExitCode::bad_input, [&] { load_scene("xylophone", problems); });
  for (const ShippedScene& shipped : shipped_scenes()) {
    EXPECT_THAT(message, HasSubstr(std::string(shipped.name)));
  }
}

TEST(Scene, AFileThatIsNotThereIsNamed) {
  std::vector<std::string> problems;
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { load_scene("no/such.toml", problems); }),
              HasSubstr("no/such.toml"));
}

}  // namespace
}  // namespace pupflow::io
