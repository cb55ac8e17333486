#include "app/window/scene_desk.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>

#include "app/io/checkpoint.h"
#include "app/io/failure.h"
#include "app/io/png_memory.h"
#include "app/io/scene_file.h"
#include "app/window/file_list.h"
#include "app/window/session/pull.h"
#include "app/window/session/session.h"
#include "pupflow/simulation.h"
#include "tests/support/scratch.h"

extern const char scene_pictures_begin[], scene_pictures_end[];

namespace pupflow::window {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::size_t place_of(std::string_view name) {
  return static_cast<std::size_t>(find_parameter(name) - parameters().data());
}

std::string refusal(const std::string& source) {
  try {
    read_scene(source);
  } catch (const io::Failure& failure) {
    return failure.what();
  }
  return {};
}

/// Made anew by scripts/scene_pictures when a scene comes or goes.
TEST(ScenePictures, EveryShippedSceneHasOne) {
  const std::string_view file(scene_pictures_begin,
                              static_cast<std::size_t>(scene_pictures_end - scene_pictures_begin));
  const io::Image image = io::read_png(file, "scene_pictures.png");
  EXPECT_EQ(image.width, 160);
  EXPECT_EQ(image.height, 120 * static_cast<int>(io::shipped_scenes().size()));
}

TEST(SceneDesk, OpensShippedScenesByName) {
  for (const io::ShippedScene& scene : io::shipped_scenes()) {
    const Opened opened = read_scene(std::string(scene.name));
    EXPECT_EQ(opened.source, scene.name);
    EXPECT_TRUE(opened.is_scene);
    EXPECT_NE(opened.title, "");
  }
  EXPECT_EQ(read_scene("cold").params.ambient_temperature, 0.2);
}

/// The longest that a run may have, late in it.
TEST(SceneDesk, AllPullsOfARunCanBeSavedAndOpened) {
  const test::Scratch scratch;
  Params recipe;
  Simulation litter(recipe);
  litter.run(10);
  for (std::size_t i = 0; i < Session::kMostPulls; ++i) {
    const auto at = 50'000'000 + 7 * static_cast<std::int64_t>(i);
    const int pup = static_cast<int>(i) % recipe.pups;
    const double way = std::sin(static_cast<double>(i));
    Change pull{.step = at, .until = at + 7, .settings = {}, .pup = pup, .action = {}};
    pull.action.force = pull_force(litter.view(), pup, {way, way / 3, way * way});
    recipe.schedule.add(pull);
  }
  const std::string path = scratch.path("pulls.toml");
  SceneDesk(Begun{}).save(path, recipe, 0);
  EXPECT_EQ(read_scene(path).params.schedule, recipe.schedule);
}

TEST(SceneDesk, OpensCheckpointsWithTheirLitter) {
  const test::Scratch scratch;
  Params params;
  params.pups = 3;
  Simulation simulation(params);
  simulation.run(7);
  const std::string path = scratch.path("c.h5");
  io::write_checkpoint(path, false, simulation);
  const Opened opened = read_scene(path);
  ASSERT_TRUE(opened.from);
  EXPECT_EQ(Simulation(*opened.from).hash(), simulation.hash());
  EXPECT_EQ(opened.params, params);
  EXPECT_EQ(opened.title, "c");
  EXPECT_FALSE(opened.is_scene);
}

TEST(SceneDesk, OpensAnyFileWithARecipe) {
  const test::Scratch scratch;
  const std::string path =
      scratch.file("m.csv", "# Software = pupflow 0.2.0\n# seed = 9\nstep\n1\n");
  EXPECT_EQ(read_scene(path).params.seed, 9);
}

TEST(SceneDesk, SaysInOneLineWhatIsWrong) {
  const test::Scratch scratch;
  EXPECT_THAT(refusal(scratch.file("a.toml", "tta = 1\nbeta = 7\n")),
              AllOf(HasSubstr("a.toml:1:1: unknown key 'tta'"), HasSubstr("a.toml:2:8: "),
                    Not(HasSubstr("\n"))));
  EXPECT_THAT(refusal(scratch.file("b.toml", "arena_radius = 0.1\n")),
              AllOf(HasSubstr("arena radius must exceed"), Not(HasSubstr("\n"))));
  EXPECT_THAT(refusal(scratch.path("none.toml")), HasSubstr("none.toml: cannot read"));
  EXPECT_THAT(refusal(scratch.file("c.png", "no picture")), HasSubstr("c.png"));
  EXPECT_THAT(refusal(scratch.folder().string()), HasSubstr(scratch.folder().string()));
}

TEST(SceneDesk, DoesNotWaitForWhatHasNoEnd) {
  const test::Scratch scratch;
  for (const std::string name : {"pipe.toml", "pipe.h5"}) {
    ASSERT_EQ(::mkfifo(scratch.path(name).c_str(), 0600), 0);
    EXPECT_THAT(refusal(scratch.path(name)), HasSubstr("is no file"));
  }
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("is no file"));
}

TEST(SceneDesk, KnowsWhatChangedSinceItWasSaved) {
  const test::Scratch scratch;
  Params recipe = read_scene("cold").params;
  SceneDesk desk(Begun{"cold", recipe, {}});
  EXPECT_EQ(desk.title(), "Cold");
  EXPECT_EQ(desk.file_name(), "cold.toml");
  EXPECT_EQ(desk.path(), "") << "shipped scenes are not written to";
  EXPECT_FALSE(desk.changed(recipe));
  recipe.schedule.set(5, place_of("ta"), 0.3);
  EXPECT_TRUE(desk.changed(recipe));
  const std::string saved = desk.save(scratch.path("mine"), recipe, 12);
  EXPECT_EQ(saved, scratch.path("mine.toml"));
  EXPECT_FALSE(desk.changed(recipe));
  EXPECT_EQ(desk.path(), saved);
  EXPECT_EQ(desk.title(), "mine");
  const Opened again = read_scene(saved);
  EXPECT_EQ(again.params, recipe);
  EXPECT_THAT(again.description, HasSubstr("step 12"));
}

TEST(SceneDesk, SavingToTheSameFileKeepsItsWords) {
  const test::Scratch scratch;
  const std::string path = scratch.file("s.toml", "title = 'My title'\ndescription = 'Why.'\n");
  SceneDesk desk(Begun{});
  desk.take(read_scene(path));
  Params recipe;
  recipe.seed = 3;
  desk.save(path, recipe, 1);
  EXPECT_EQ(desk.title(), "My title");
  EXPECT_EQ(read_scene(path).description, "Why.");
  EXPECT_EQ(read_scene(path).params.seed, 3);
}

TEST(SceneDesk, WhatCannotBeSavedLeavesTheChanges) {
  const test::Scratch scratch;
  SceneDesk desk(Begun{});
  Params recipe;
  recipe.seed = 3;
  EXPECT_THROW(desk.save(scratch.path("no/folder.toml"), recipe, 0), io::Failure);
  EXPECT_TRUE(desk.changed(recipe));
  EXPECT_EQ(desk.title(), "untitled");
}

TEST(SceneDesk, TheCommandBeginsWithTheScene) {
  Params recipe = read_scene("cold").params;
  recipe.rigidity = 0.5;  // as if --set had been typed
  const SceneDesk desk(Begun{"cold", recipe, {}});
  EXPECT_FALSE(desk.changed(recipe));
  EXPECT_EQ(desk.command(recipe, 40), "pupflow run cold --set alpha=0.5 --seed 1 --steps 40");
  EXPECT_EQ(SceneDesk(Begun{}).command(Params{}, 3), "pupflow run --seed 1 --steps 3");
}

TEST(FileList, ListsFoldersThenScenesThenOtherFilesThatCanBeOpened) {
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch.folder() / "z");
  for (const char* name : {"b.toml", "a.toml", "p.png", "c.h5", "notes.txt", ".hidden.toml"}) {
    scratch.file(name, "");
  }
  const auto names = [](const FileList& list) {
    std::vector<std::string> all;
    for (const FileList::Entry& entry : list.entries) all.push_back(entry.name);
    return all;
  };
  EXPECT_THAT(names(list_files(scratch.folder().string(), false)),
              ElementsAre("z", "a.toml", "b.toml", "c.h5", "p.png"));
  EXPECT_THAT(names(list_files(scratch.folder().string(), true)),
              ElementsAre("z", "a.toml", "b.toml"));
  const FileList none = list_files(scratch.path("none"), false);
  EXPECT_THAT(none.entries, IsEmpty());
  EXPECT_THAT(none.problem, HasSubstr("cannot list"));
}

TEST(FileList, PathsAreSeenFromTheFolder) {
  EXPECT_EQ(path_from("/a/b", "c.toml"), "/a/b/c.toml");
  EXPECT_EQ(path_from("/a/b", "../c.toml"), "/a/c.toml");
  EXPECT_EQ(path_from("/a/b", "/c/"), "/c");
  EXPECT_EQ(path_from("/a/b", "/"), "/");
  EXPECT_EQ(path_from("/a", "~").substr(0, 1), "/");
}

}  // namespace
}  // namespace pupflow::window
