// The command line of every verb, as a user sees it.
#include <gmock/gmock.h>

#include "program.h"
#include "pupflow/observer.h"
#include "pupflow/parameters.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;

const std::vector<std::string> kVerbs{"live",   "run",    "render", "figure1", "explain",
                                      "params", "fields", "scenes", "doctor"};

class Cli : public testing::Test {
 protected:
  Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }

  /// Wrong input: exit code 2, nothing on standard output, every line of the error told to be ours.
  std::string refused(const std::vector<std::string>& arguments) const {
    const Outcome outcome = pupflow(arguments);
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, MatchesRegex("(pupflow: [^\n]+\n)+"));
    EXPECT_EQ(scratch_.entries(), 0) << testing::PrintToString(arguments);
    return outcome.err;
  }

  test::Scratch scratch_;
};

TEST_F(Cli, EveryVerbHasHelpAndTheCommonOptions) {
  const Outcome top = pupflow({"--help"});
  EXPECT_EQ(top.code, 0);
  for (const std::string& verb : kVerbs) {
    EXPECT_THAT(top.out, HasSubstr("\n  " + verb + " "));
    const Outcome help = pupflow({verb, "--help"});
    EXPECT_EQ(help.code, 0) << verb;
    EXPECT_THAT(help.err, IsEmpty()) << verb;
    for (const char* option : {"--set", "--like", "--seed", "--steps", "--threads", "--precision",
                               "--out", "--force", "--quiet"}) {
      EXPECT_THAT(help.out, HasSubstr(option)) << verb;
    }
  }
  EXPECT_THAT(pupflow({"--version"}).out, MatchesRegex("pupflow [0-9.]+\n"));
}

TEST_F(Cli, WrongCommandLinesAreRefusedWithAHint) {
  EXPECT_THAT(refused({}), HasSubstr("no verb given"));
  EXPECT_THAT(refused({"rum"}), HasSubstr("did you mean 'run'?"));
  EXPECT_THAT(refused({"run", "--presicion", "float"}), HasSubstr("did you mean '--precision'?"));
  EXPECT_THAT(refused({"run", "cold", "warm"}), HasSubstr("unexpected argument 'warm'"));
  EXPECT_THAT(refused({"run", "--set"}), HasSubstr("--set needs a value"));
  EXPECT_THAT(refused({"run", "--seed", "1", "--seed", "2"}), HasSubstr("--seed is given twice"));
  EXPECT_THAT(refused({"run", "--every", "0"}), HasSubstr("--every"));
  EXPECT_THAT(refused({"run", "--threads", "0"}), HasSubstr("--threads"));
  EXPECT_THAT(refused({"params", "--format", "xml"}), HasSubstr("markdown"));
  EXPECT_THAT(refused({"run", "--ta", "0.2"}), HasSubstr("--set ta=0.2"));
  EXPECT_THAT(refused({"sweep", "--pup-radius=0.2"}), HasSubstr("--set pup_radius=0.2"));
  EXPECT_THAT(refused({"run", "clod"}), HasSubstr("did you mean 'cold'?"));
  EXPECT_THAT(refused({"run", "--force=no"}), HasSubstr("--force takes no value"));
  EXPECT_THAT(refused({"compare", "a"}), HasSubstr("SWEEP must be given twice"));
  EXPECT_THAT(refused({"merge"}), HasSubstr("FOLDER must be given"));
  EXPECT_THAT(refused({"params", "--format", "jsno"}), HasSubstr("did you mean 'json'?"));
  EXPECT_THAT(refused({"explain", "--json", "--measure"}), HasSubstr("leave one out"));
  EXPECT_THAT(refused({"--nope"}), HasSubstr("unknown option '--nope'"));
}

TEST_F(Cli, EveryVerbRefusesAnUnknownParameter) {
  for (const std::string& verb : kVerbs) {
    EXPECT_THAT(refused({verb, "--set", "alpa=1"}), HasSubstr("did you mean 'alpha'?")) << verb;
    EXPECT_THAT(refused({verb, "--set", "alpha=2"}), HasSubstr("alpha = 2")) << verb;
  }
}

TEST_F(Cli, AMistypedChoiceGetsTheNearest) {
  scratch_.file("s.toml", "contact = \"nerest\"\n");
  const std::vector<std::vector<std::string>> lines{{"run", "--set", "contact=nerest"},
                                                    {"run", "--at", "step=5,contact=nerest"},
                                                    {"run", "s.toml"},
                                                    {"sweep", "--vary", "contact=nerest,sum"}};
  for (const auto& line : lines) {
    const Outcome outcome = pupflow(line);
    EXPECT_EQ(outcome.code, 2) << line.back();
    EXPECT_THAT(outcome.err, HasSubstr("nearest or mean or sum; did you mean 'nearest'?\n"));
  }
  EXPECT_THAT(pupflow({"run", "--set", "contact=x"}).err, Not(HasSubstr("did you mean")));
}

TEST_F(Cli, ANumberIsToldAsItWasTyped) {
  EXPECT_THAT(refused({"run", "--seed", "18446744073709551615"}),
              HasSubstr("seed = 18446744073709551615: "));
  EXPECT_THAT(refused({"run", "--set", "alpha=2.50"}), HasSubstr("alpha = 2.50: "));
}

TEST_F(Cli, AllProblemsAreListedALineEach) {
  const std::string errors = refused({"run", "--set", "ta=x", "--set", "alpha=2", "--steps", "-1"});
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 3);
}

TEST_F(Cli, ASceneErrorNamesItsPlace) {
  const std::string path = scratch_.file("s.toml", "ta = 0.2\nalpa = 0.5\n");
  const Outcome outcome = pupflow({"run", "s.toml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "pupflow: s.toml:2:1: unknown key 'alpa'; did you mean 'alpha'?\n");
  EXPECT_EQ(pupflow({"run", "none.toml"}).code, 4);
}

TEST_F(Cli, AFileThatIsNoSceneIsNotTakenForAName) {
  scratch_.file("earlier.csv", "step\n");
  const Outcome outcome = pupflow({"explain", "earlier.csv"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, testing::StartsWith("pupflow: 'earlier.csv': a scene file is given as"));
  EXPECT_THAT(outcome.err, HasSubstr("--like"));
}

TEST_F(Cli, ParamsListsEveryParameterInEachFormat) {
  for (const char* format : {"text", "markdown", "json"}) {
    const Outcome outcome = pupflow({"params", "--format", format});
    EXPECT_EQ(outcome.code, 0);
    for (const Parameter& parameter : parameters()) {
      const std::string name(parameter.name);
      const std::string wanted = std::string_view(format) == "text"       ? "\n" + name + " "
                                 : std::string_view(format) == "markdown" ? "| `" + name + "` |"
                                                                          : "\"" + name + "\"";
      EXPECT_THAT(outcome.out, HasSubstr(wanted)) << format;
    }
  }
  EXPECT_THAT(pupflow({"params", "cold", "--format", "json"}).out,
              HasSubstr("\"default\": 0.4, \"value\": 0.2"));
}

TEST_F(Cli, FieldsListsEveryFieldInEachFormat) {
  std::vector<std::string> names;
  for (const Field& field : run_statistics()) names.emplace_back(field.name);
  for (const Field& field : pup_fields()) names.emplace_back(field.name);
  for (const Field& field : afferent_fields()) names.emplace_back(field.name);
  for (const std::string format : {"text", "markdown", "json"}) {
    const Outcome outcome = pupflow({"fields", "--format", format});
    EXPECT_EQ(outcome.code, 0);
    for (const std::string& name : names) {
      const std::string wanted = format == "text"       ? "\n" + name + " "
                                 : format == "markdown" ? "| `" + name + "` |"
                                                        : "{\"name\": \"" + name + "\"";
      EXPECT_THAT(outcome.out, HasSubstr(wanted)) << format;
    }
  }
  EXPECT_THAT(pupflow({"fields"}).out,
              testing::ContainsRegex("heading +pup +θ +rad +−π … π +angle"));
  EXPECT_THAT(refused({"fields", "--format", "xml"}), HasSubstr("markdown"));
}

TEST_F(Cli, OutWritesAFileAndForceReplacesIt) {
  ASSERT_EQ(pupflow({"params", "--out", "p.txt"}).code, 0);
  EXPECT_EQ(test::contents(scratch_.path("p.txt")), pupflow({"params"}).out);
  EXPECT_EQ(pupflow({"params", "--out", "p.txt"}).code, 4);
  EXPECT_EQ(pupflow({"params", "--out", "p.txt", "--force"}).code, 0);
}

TEST_F(Cli, AStandardOutputThatIsFullIsReported) {
  const Outcome outcome = test::run_program(
      "/bin/sh", {"-c", "exec \"$0\" params > /dev/full", PUPFLOW_PROGRAM}, scratch_.path(""));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, MatchesRegex("pupflow: standard output: [^\n]+\n"));
}

}  // namespace
}  // namespace pupflow
