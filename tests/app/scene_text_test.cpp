// Recipes written as scenes and as commands, and read back.
#include "app/io/scene_text.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <random>

#include "app/io/command_text.h"
#include "app/io/toml_text.h"

namespace pupflow::io {
namespace {

using testing::IsEmpty;

Scene read_back(const std::string& text) {
  std::vector<std::string> problems;
  const Scene scene = parse_scene(text, "s.toml", problems);
  EXPECT_THAT(problems, IsEmpty()) << text;
  return scene;
}

std::size_t place_of(std::string_view name) {
  return static_cast<std::size_t>(find_parameter(name) - parameters().data());
}

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double share() { return std::uniform_real_distribution<double>(0, 1)(bits_); }
  std::int64_t whole(std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(0, most)(bits_);
  }
  double signed_size() { return (share() - 0.5) * std::pow(10, 40 * share() - 20); }

  /// Any value in the parameter's range.
  double value(const Parameter& parameter) {
    if (parameter.kind == Parameter::Kind::choice) {
      return static_cast<double>(whole(static_cast<std::int64_t>(parameter.choices.size()) - 1));
    }
    const double low = std::max(parameter.min, -1e20), high = std::min(parameter.max, 1e20);
    if (parameter.kind == Parameter::Kind::integer) {
      return std::floor(low + share() * (std::min(high, kExactInteger) - low));
    }
    const double wide = low + share() * (high - low);
    const double value = share() < 0.5 ? wide : wide * std::pow(10, -20 * share());
    Problem unused;
    return check_value(parameter, value, unused) ? value : parameter.default_value();
  }

  Change change() {
    Change change;
    change.step = whole(share() < 0.5 ? 3 : 9007199254740990);
    if (share() < 0.5) change.until = change.step + 1 + whole(1000);
    if (share() < 0.5) {
      change.pup = static_cast<int>(whole(99));
      change.action.force = {signed_size(), -0.0, signed_size()};
      if (share() < 0.5) change.action.heat = signed_size();
      if (share() < 0.5) change.action.turn = signed_size();
      return change;
    }
    for (std::size_t i = 0; i < parameters().size(); ++i) {
      const Parameter& parameter = parameters()[i];
      const bool goes = parameter.effect == Parameter::Effect::next_step && share() < 0.3;
      if (goes) change.settings.push_back({i, value(parameter)});
    }
    return change;
  }

  Params params() {
    Params params;
    for (const Parameter& parameter : parameters()) {
      if (share() < 0.5) parameter.set(params, value(parameter));
    }
    for (auto changes = whole(8); changes > 0; --changes) params.schedule.add(change());
    return params;
  }

 private:
  std::mt19937 bits_;
};

TEST(SceneText, AnyRecipeReadsBackToTheSame) {
  Random random(20);
  for (int round = 0; round < 300; ++round) {
    const Scene scene{"Round " + std::to_string(round), "\"two\"\nlines\\", random.params()};
    const std::string text = scene_text(scene);
    const Scene read = read_back(text);
    ASSERT_EQ(read.params, scene.params) << text;
    EXPECT_EQ(read.title, scene.title);
    EXPECT_EQ(read.description, scene.description);
  }
}

TEST(SceneText, EveryShippedSceneReadsBackToTheSame) {
  for (const ShippedScene& shipped : shipped_scenes()) {
    const Scene scene = read_back(std::string(shipped.text));
    const Scene again = read_back(scene_text(scene));
    EXPECT_EQ(again.params, scene.params) << shipped.name;
    EXPECT_EQ(again.description, scene.description);
  }
}

TEST(SceneText, NamesTheSeedAndWhatIsNotTheDefault) {
  Scene scene;
  scene.title = "Mine";
  scene.params.ambient_temperature = 0.2;
  EXPECT_EQ(scene_text(scene), "title = \"Mine\"\nta = 0.2\nseed = 1\n");
}

TEST(TomlText, NumbersKeepTheirBits) {
  for (const double value : {0.0, -0.0, 1.0, 0.1, 1e15, 1e22, 9.3e18, 1e300, 5e-324, -2.5e-7}) {
    Scene scene;
    Change change;
    change.pup = 0;
    change.action.force = {1, value, 0};
    scene.params.schedule.add(change);
    const Params read = read_back(scene_text(scene)).params;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.schedule.changes()[0].action.force[1]),
              std::bit_cast<std::uint64_t>(value))
        << toml_number(value);
  }
}

TEST(CommandText, SaysOnlyWhatDiffersFromTheScene) {
  Params base;
  base.ambient_temperature = 0.2;
  base.schedule.set(100, place_of("drive"), 0.5);
  Params recipe = base;
  EXPECT_EQ(command_text("cold", base, recipe, 7), "pupflow run cold --seed 1 --steps 7");
  recipe.rigidity = 0.25;
  recipe.seed = 9;
  recipe.schedule.set(100, place_of("ta"), 0.5);
  EXPECT_EQ(command_text("my scene.toml", base, recipe, 7),
            "pupflow run 'my scene.toml' --set alpha=0.25 --at step=100,ta=0.5 --seed 9 --steps 7");
}

TEST(CommandText, LeavesTheSceneOutWhereItsChangesAreNoMore) {
  Params base;
  base.schedule.set(100, place_of("ta"), 0.5);
  Params recipe = base;
  recipe.schedule = {};
  EXPECT_EQ(command_text("cold", base, recipe, 7), "pupflow run --seed 1 --steps 7");
}

TEST(CommandText, WordsAreOneWordForTheShell) {
  EXPECT_EQ(shell_word("a.toml"), "a.toml");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
}

}  // namespace
}  // namespace pupflow::io
