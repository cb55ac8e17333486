// What leaving out saves: left-out parts cost nothing, and forced in they change no bit.
#include "app/report/savings/savings.h"

#include <gmock/gmock.h>

#include <functional>

#include "app/io/failure.h"
#include "app/io/scene_file.h"
#include "app/report/report.h"
#include "app/report/savings/stage_timer.h"
#include "pupflow/simulation.h"
#include "tests/support/scratch.h"

namespace pupflow::report {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

Params shipped(const char* name) {
  std::vector<std::string> problems;
  const Params params = io::load_scene(name, problems).params;
  EXPECT_THAT(problems, testing::IsEmpty());
  return params;
}

Savings measured(const Params& params) {
  return measure_savings(params, {300, 20, 1, true});
}

struct Case {
  const char* name;
  std::function<Params()> params;
  std::vector<std::string> left_out;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const std::vector<Case> kCases{
    {"paper",
     [] { return shipped("paper"); },
     {"touching pairs", "felt sides", "strain", "pose", "observables"}},
    {"single",
     [] { return shipped("single"); },
     {"contact", "steering", "mean T_c", "strain", "pose", "observables"}},
    {"rigid",
     [] { return shipped("rigid"); },
     {"touching pairs", "felt sides", "quadratic terms", "strain", "pose", "observables"}},
    {"no_heat",
     [] { return shipped("no_heat"); },
     {"touching pairs", "felt sides", "heat", "strain", "pose", "observables"}},
    {"no_steering",
     [] { return shipped("no_steering"); },
     {"touching pairs", "steering", "strain", "pose", "observables"}},
    {"quiet",
     [] {
       Params p;
       p.drive = p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
       p.initial_temperature =
           0.5;  // colder than they like, so that a forced steering does turn them
       p.precision = Precision::float_;
       return p;
     },
     {"exposed share", "touched pups", "touching pairs", "steering", "heat", "strain", "pose",
      "observables"}},
    {"no_gain_by_the_body",
     [] {
       Params p;
       p.heading = Heading::body;
       p.steering_gain = 0;
       return p;
     },
     {"touching pairs", "turn", "felt sides", "strain", "pose", "observables"}},
    {"no_heat_between_pups",
     [] {
       Params p;
       p.contact_conductance = 0;
       return p;
     },
     {"touching pairs", "felt sides", "mean T_c", "strain", "pose", "observables"}},
    {"free",
     [] {
       Params p;
       p.deformation = 1;
       p.face_points = 3;
       return p;
     },
     {"touching pairs", "felt sides", "rotation", "strain", "pose", "observables"}},
    {"no_goals",
     [] {
       Params p;
       p.rigidity = 0;
       return p;
     },
     {"touching pairs", "felt sides", "shape_match", "observables"}},
    {"nobody",
     [] {
       Params p;
       p.pups = 0;
       return p;
     },
     {"boundary", "contact", "steering", "heat", "predict", "shape_match", "observables"}},
};

struct SavingsOf : testing::TestWithParam<Case> {};

TEST_P(SavingsOf, LeftOutPartsCostNothingAndChangeNoBit) {
  const Params params = GetParam().params();
  const Savings savings = measured(params);
  EXPECT_NO_THROW(require_same_bits(savings));
  EXPECT_EQ(savings.first, 301);
  EXPECT_EQ(savings.last, 320);
  const auto expected = [&](bool steered) {
    return params.drive == 0 && params.pups > 0 && steered ? Agreement::all_but_headings
                                                           : Agreement::whole_state;
  };
  std::vector<std::string> left_out;
  for (const PartCost& part : savings.parts) {
    SCOPED_TRACE(part.name);
    if (part.needed) {
      EXPECT_EQ(part.agreement, Agreement::needed);
      EXPECT_EQ(part.forced, 0);
      continue;
    }
    left_out.push_back(part.name);
    EXPECT_EQ(part.planned, 0) << "it was left out, so it took no time";
    // A part of a stage may take less than the clock can tell.
    if (!part.of_stage) {
      EXPECT_NE(part.forced, 0) << "it was forced in, so it took some";
    }
    EXPECT_FALSE(part.reason.empty());
    EXPECT_EQ(part.agreement, expected(part.name == "steering"));
  }
  std::vector<std::string> expected_names = GetParam().left_out;
  if (params.pups > 0) expected_names.emplace_back("all but mean T_b");  // of the observables
  EXPECT_THAT(left_out, ElementsAreArray(expected_names));
  EXPECT_EQ(savings.agreement, expected(true));
}

INSTANTIATE_TEST_SUITE_P(Savings, SavingsOf, testing::ValuesIn(kCases),
                         [](const auto& scene) { return scene.param.name; });

TEST(Savings, TheHashIsThatOfTheSceneRunByItself) {
  const Params params = shipped("single");
  Simulation simulation(params);
  simulation.run(320);
  EXPECT_EQ(measured(params).hash, simulation.hash());
}

/// With figures that are easy to read.
Savings made_up() {
  Savings savings;
  savings.first = 11;
  savings.last = 20;
  savings.parts = {{"contact", false, true, "", 75},
                   {"steering", false, false, "drive = 0", 0, 12.5, Agreement::all_but_headings},
                   {"shape_match", false, true, "", 25},
                   {"quadratic terms", true, false, "beta = 0", 0, 5, Agreement::whole_state}};
  savings.planned_step = 100;
  savings.full_step = 118;
  savings.saved = 17.5;
  savings.agreement = Agreement::all_but_headings;
  savings.clock = 0.02;
  savings.hash = 0xabc;
  savings.rest_hash = 0xdef;
  return savings;
}

TEST(Savings, ATableOfThem) {
  EXPECT_EQ(
      io::aligned(savings_rows(made_up())),
      "stage              needed  µs a step  of the step   forced in  saved      the same bits\n"
      "contact            yes         75.00  ############          -          -  -\n"
      "steering           no              0                    12.50      12.50  all but headings\n"
      "shape_match        yes         25.00  ####                  -          -  -\n"
      "- quadratic terms  no              0                     5.00       5.00  whole state\n"
      "whole step                    100.00                   118.00      17.50  all but "
      "headings\n");
  EXPECT_THAT(savings_notes(made_up()),
              ElementsAre(HasSubstr("steps 11 to 20"),
                          "Left out: steering (drive = 0); quadratic terms (beta = 0).",
                          HasSubstr("the hash of the whole state is 0000000000000abc"),
                          HasSubstr("0000000000000def in both cases")));
}

TEST(Savings, AChangedBitIsADefect) {
  Savings savings = made_up();
  EXPECT_NO_THROW(require_same_bits(savings));
  savings.parts[3].agreement = Agreement::none;
  EXPECT_THAT(savings_rows(savings)[4].back(), "NO");
  try {
    require_same_bits(savings);
    FAIL();
  } catch (const io::Failure& failure) {
    EXPECT_EQ(failure.code(), io::ExitCode::bad_numbers);
    EXPECT_THAT(failure.what(),
                HasSubstr("quadratic terms forced in has changed the state after step 20"));
  }
}

TEST(Savings, BadNumbersEndTheMeasuring) {
  Params params;
  params.heat = HeatRule::euler;
  params.air_conductance = 500;  // where forward Euler overshoots by more in every step
  EXPECT_THROW(measure_savings(params, {1500, 1, 1, true}), io::Failure);
}

TEST(Savings, TheSectionShowsFiveScenes) {
  const test::Scratch scratch;
  Options options;
  options.folder = scratch.path("report");
  options.command = "pupflow report error --quick";
  options.quick = options.quiet = true;
  Report report(options, "A title");
  savings_section(report);
  report.finish();
  const std::string page = test::contents(scratch.path("report/report.md"));
  for (const char* name : {"paper", "single", "rigid", "no_heat", "no_steering"}) {
    EXPECT_THAT(page, HasSubstr("(`" + std::string(name) + "`)\n"));
  }
  EXPECT_THAT(page, HasSubstr("| whole state |"));
  EXPECT_THAT(page, testing::Not(HasSubstr("| NO |")));
  const std::string csv = test::contents(scratch.path("report/savings.csv"));
  EXPECT_THAT(csv, HasSubstr("\nscene,part,needed,planned_us,forced_us,saved_us,the_same_bits\n"));
  EXPECT_THAT(csv,
              testing::ContainsRegex("\nsingle,contact,0,0,[0-9.e-]+,[0-9.e-]+,whole state\n"));
  EXPECT_THAT(csv, testing::ContainsRegex("\npaper,contact,1,[0-9.]+,nan,nan,-\n"));
}

TEST(StageTimer, KnowsTheMedian) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({7}), 7);
}

TEST(StageTimer, CountsOnlyStagesThatRan) {
  StageTimer timer;
  timer.stage_begins(Stage::heat);
  timer.stage_ends(Stage::heat);
  EXPECT_THAT(timer.times(Stage::heat), testing::SizeIs(1));
  EXPECT_GE(timer.median(Stage::heat), 0);
  EXPECT_THAT(timer.times(Stage::contact), testing::IsEmpty());
  EXPECT_EQ(timer.median(Stage::contact), 0);
}

}  // namespace
}  // namespace pupflow::report
