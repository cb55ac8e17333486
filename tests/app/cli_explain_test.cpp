// pupflow explain: what a scene needs, what that costs, and what leaving out saves.
#include <gmock/gmock.h>

#include <sstream>

#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using test::Outcome;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class CliExplain : public testing::Test {
 protected:
  Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }

  /// What `explain SCENE --measure` prints.
  std::string measured(const std::string& scene) const {
    const Outcome outcome = pupflow({"explain", scene, "--measure", "--after", "150", "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, Not(HasSubstr(" NO\n")));
    return outcome.out;
  }

  test::Scratch scratch_;
};

/// A row of a stage that was left out: no time as planned, and the same bits with it.
std::string left_out(const std::string& part) {
  return "\n" + part + " +no +0 +-?[0-9.]+ +-?[0-9.]+ +whole state\n";
}

/// Characters of the longest line.
std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto characters =
        std::count_if(line.begin(), line.end(), [](char c) { return (c & '\xC0') != '\x80'; });
    longest = std::max(longest, static_cast<std::size_t>(characters));
  }
  return longest;
}

TEST_F(CliExplain, TellsWhichStagesAreInAndWhy) {
  const Outcome outcome = pupflow({"explain", "--set", "pups=1", "--after", "3", "--quiet"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, ContainsRegex("\nboundary +yes +[0-9.]+ +[#.]+ +[a-z]"));
  EXPECT_THAT(outcome.out, ContainsRegex("\ncontact +no +- +[a-z]"));
  EXPECT_THAT(outcome.out, ContainsRegex("\nwhole step +[0-9.]+"));
  EXPECT_THAT(outcome.out, HasSubstr("steps 4 to 203"));
  EXPECT_LE(longest_line(outcome.out), 100u);
}

TEST_F(CliExplain, TellsWhichPartsOfAStageAreOutAndWhy) {
  const Outcome outcome =
      pupflow({"explain", "--set", "heading=body", "--set", "v=0", "--set", "k2=0", "--set",
               "beta=1", "--set", "face_points=3", "--after", "3", "--quiet"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, ContainsRegex("\nsteering +yes +[0-9.]+ +[#.]+ +[a-z]"));
  EXPECT_THAT(outcome.out, ContainsRegex("\n- turn +no +- +v = 0: no pup turns\n"));
  EXPECT_THAT(outcome.out, ContainsRegex("\n- mean T_c +no +- +k2 = 0: "));
  EXPECT_THAT(outcome.out, ContainsRegex("\n- rotation +no +- +beta = 1: "));
  EXPECT_THAT(outcome.out, Not(HasSubstr("\n- quadratic"))) << "it is needed";
  EXPECT_LE(longest_line(outcome.out), 100u);
}

TEST_F(CliExplain, MeasuresThatWhatIsLeftOutCostsNothingAndChangesNothing) {
  const std::string single = measured("single");
  EXPECT_THAT(single, ContainsRegex(left_out("contact")));
  EXPECT_THAT(single, ContainsRegex(left_out("steering")));
  EXPECT_THAT(single, ContainsRegex(left_out("observables")));
  EXPECT_THAT(single, ContainsRegex("\nheat +yes +[0-9.]+ +[#.]+ +- +- +-\n"));
  EXPECT_THAT(single, ContainsRegex("\nwhole step +[0-9.]+ +[0-9.]+ +-?[0-9.]+ +whole state\n"));
  EXPECT_THAT(measured("no_heat"), ContainsRegex(left_out("heat")));
  EXPECT_THAT(measured("rigid"), ContainsRegex(left_out("- quadratic terms")));
  EXPECT_LE(longest_line(single), 100u);
}

TEST_F(CliExplain, MeasuresOnAsManyThreadsAsAsked) {
  const std::vector<std::string> call{"explain", "--after", "5", "--quiet"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), call.begin(), call.end());
    return pupflow(more).out;
  };
  EXPECT_THAT(with({}), HasSubstr("one thread"));
  EXPECT_THAT(with({"--threads", "2"}), HasSubstr("2 threads"));
  EXPECT_THAT(with({"--threads", "2", "--measure"}), HasSubstr("2 threads"));
}

TEST_F(CliExplain, SaysWhichBitsAreComparedWhereNothingDrives) {
  const std::string text = measured("no_steering");
  EXPECT_THAT(text, ContainsRegex("\nsteering +no +0 +[0-9.]+ +[0-9.]+ +all but headings\n"));
  EXPECT_THAT(text, HasSubstr("Steering turns the headings of pups that have no drive"));
}

TEST_F(CliExplain, RefusesAnOutputBeforeItMeasures) {
  scratch_.file("taken.txt", "mine");
  const Outcome outcome =
      pupflow({"explain", "--after", "9007199254740992", "--measure", "--out", "taken.txt"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("taken.txt: exists already"));
}

TEST_F(CliExplain, StopsWhereNumbersGoWrong) {
  for (const bool measure : {false, true}) {
    std::vector<std::string> call{"explain", "--set",   "heat=euler", "--set",
                                  "k1=500",  "--after", "2000",       "--quiet"};
    if (measure) call.emplace_back("--measure");
    const Outcome outcome = pupflow(call);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("step "));
  }
}

}  // namespace
}  // namespace pupflow
