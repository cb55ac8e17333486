// Changes during a run, as they are typed, read from scenes and carried by outputs.
#include "app/io/schedule_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/io/provenance.h"
#include "app/io/scene_file.h"
#include "app/io/settings.h"
#include "failing.h"
#include "pupflow/parameters.h"

namespace pupflow::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kAll =
    "step=0,until=70,ta=0.25,gravity=1e-07; step=800,contact=mean,drive=2; "
    "step=1200,until=1260,pup=3,force=[2,0,-0.5],heat=0.1,turn=-0.25; step=1300,pup=0,turn=0";

Schedule parsed(std::string_view text) {
  std::vector<std::string> problems;
  const Schedule schedule = parse_schedule(text, "here", problems);
  EXPECT_THAT(problems, IsEmpty());
  return schedule;
}

std::vector<std::string> problems_of(std::string_view text) {
  std::vector<std::string> problems;
  Schedule schedule;
  add_change(text, "--at", schedule, problems);
  EXPECT_EQ(schedule.empty(), !problems.empty());
  return problems;
}

TEST(ScheduleText, ReadsBackToTheSame) {
  const Schedule schedule = parsed(kAll);
  EXPECT_EQ(schedule.changes().size(), 4u);
  EXPECT_EQ(schedule_text(schedule), kAll);
  Params params;
  params.schedule = schedule;
  EXPECT_THAT(check(params), IsEmpty());
  EXPECT_EQ(params_from(provenance(params), "here"), params);
}

TEST(ScheduleText, BlanksDoNotMatter) {
  EXPECT_EQ(parsed("step = 5, pup = 1, force = [1, 2, 3]"), parsed("step=5,pup=1,force=[1,2,3]"));
}

TEST(ScheduleText, WhatIsWrongIsSaidOnce) {
  EXPECT_THAT(problems_of("500"), ElementsAre("--at: '500' is no change, e.g. step=800,ta=0.2"));
  EXPECT_THAT(problems_of(""), ElementsAre(HasSubstr("is no change")));
  EXPECT_THAT(problems_of("ta=0.2"), ElementsAre(HasSubstr("a change needs its step")));
  EXPECT_THAT(problems_of("step=1.5,ta=0.2"),
              ElementsAre(HasSubstr("step must be a whole number, not '1.5'")));
  EXPECT_THAT(problems_of("step=1,tta=0.2"),
              ElementsAre(HasSubstr("no 'tta'; did you mean 'ta'?")));
  EXPECT_THAT(problems_of("step=1,ta=cold"), ElementsAre(HasSubstr("ta = 'cold'")));
  EXPECT_THAT(problems_of("step=1,ta=0,ta=1"), ElementsAre(HasSubstr("ta is given twice")));
  EXPECT_THAT(problems_of("step=1,turn=1"), ElementsAre(HasSubstr("turn acts on one pup")));
  EXPECT_THAT(problems_of("step=1,pup=1,force=[1,2]"), ElementsAre(HasSubstr("three numbers")));
  EXPECT_THAT(problems_of("step=1,pup=1,force=[1,2"), ElementsAre(HasSubstr("three numbers")));
  EXPECT_THAT(problems_of("step=1,pup=1,force=1]],ta=2,x=["), testing::Not(IsEmpty()));
}

TEST(ScheduleText, ScenesHaveTables) {
  std::vector<std::string> problems;
  const Scene scene = parse_scene(R"(ta = 0.5
[[at]]
step = 0
until = 70
ta = 0.25
gravity = 1e-7
[[at]]
step = 800
contact = "mean"
drive = 2
[[at]]
step = 1200
until = 1260
pup = 3
force = [2, 0, -0.5]
heat = 0.1
turn = -0.25
[[at]]
step = 1300
pup = 0
turn = 0
)",
                                  "s.toml", problems);
  EXPECT_THAT(problems, IsEmpty());
  EXPECT_EQ(scene.params.schedule, parsed(kAll));
}

TEST(ScheduleText, ScenesSayWhereAChangeIsWrong) {
  const auto problems_in = [](std::string_view text) {
    std::vector<std::string> problems;
    parse_scene(text, "s.toml", problems);
    return problems;
  };
  EXPECT_THAT(
      problems_in("[[at]]\nstep = 5\nta = \"warm\"\npups = true\n"),
      ElementsAre(HasSubstr("s.toml:4:8: pups must be"), HasSubstr("s.toml:3:6: ta = 'warm'")));
  EXPECT_THAT(problems_in("ta = 0.1\n[[at]]\nta = 0.2\n"),
              ElementsAre(HasSubstr("s.toml:3:6: a change needs its step")));
  EXPECT_THAT(problems_in("[[at]]\n"),
              ElementsAre(HasSubstr("s.toml:1:1: a change needs its step")));
  EXPECT_THAT(problems_in("at = 5\n"),
              ElementsAre(HasSubstr("s.toml:1:6: changes are written as [[at]] tables")));
  EXPECT_THAT(problems_in("[at]\nstep = 5\n"),
              ElementsAre(HasSubstr("changes are written as [[at]] tables")));
}

TEST(ScheduleText, TypedChangesFollowThoseOfTheScene) {
  Settings settings;
  settings.at = {"step=900,ta=0.7", "step=100,ta=0.2"};
  EXPECT_EQ(set_up(settings).params.schedule, parsed("step=100,ta=0.2; step=900,ta=0.7"));
  settings.at = {"step=900,tta=0.7", "nothing", "step=5,ta=0.1", "step=6,pups=3"};
  EXPECT_THAT(test::failure_of(ExitCode::bad_input, [&] { set_up(settings); }),
              HasSubstr("no 'tta'"));
  EXPECT_THAT(test::failure_of(ExitCode::bad_input, [&] { set_up(settings); }),
              HasSubstr("'nothing' is no change"));
  EXPECT_THAT(test::failure_of(ExitCode::bad_input, [&] { set_up(settings); }),
              HasSubstr("at step 6: pups can only be set for the whole run"));
}

}  // namespace
}  // namespace pupflow::io
