// Every option of every verb with values that make no sense: an error is one line of this program's
// own words, never a library's.
#include <gmock/gmock.h>

#include <array>
#include <map>
#include <set>
#include <sstream>

#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

namespace fs = std::filesystem;

using test::Outcome;
using testing::HasSubstr;
using testing::Not;

using Words = std::vector<std::string>;

/// Words of CLI11, toml++, libhdf5, libpng and the C++ library.
constexpr const char* kOfLibraries[] = {
    "required",    "requires",   "not in range", "Value ", "disallowed", "At Most", "At most",
    "Error while", ", expected", "H5",           "libpng", "std::",      "basic_",  "terminate",
    "what()",      "internal",   "stod",         "stoi",   "could not",  "TEXT",    "INT"};

/// What keeps each verb's work small.
const std::map<std::string, Words> kSmall{{"run", {"--steps", "0"}},
                                          {"render", {"--steps", "0", "--size", "64x64"}},
                                          {"figure1", {"--steps", "0", "--panel", "120"}},
                                          {"figure2", {"--steps", "1"}},
                                          {"sweep", {"--steps", "1", "--vary", "ta=0.2,0.4"}},
                                          {"explain", {"--set", "pups=0", "--after", "0"}},
                                          {"live", {"--exit-after", "0"}}};

class CliWords : public testing::Test {
 protected:
  CliWords() {
    fs::copy_file(PUPFLOW_PROGRAM, program());
    fs::copy_file(PUPFLOW_FAKE_GRAPHICS, scratch_.path("libpupflow_graphics.so"));
    work_ = scratch_.folder() / "work";
  }

  std::string program() const { return scratch_.path("pupflow"); }

  /// In a folder that is made anew.
  Outcome pupflow(const Words& words) const {
    fs::remove_all(work_);
    fs::create_directories(work_ / "folder");
    return test::run_program(program(), words, work_.string());
  }

  /// The first words of the lines of `section` in the help of a verb; all names of an option.
  Words names_in(const std::string& section, const std::string& help) const {
    std::istringstream lines(help);
    Words names;
    std::string line;
    while (std::getline(lines, line) && line != section + ":") {
    }
    while (std::getline(lines, line) && !line.empty()) {
      if (line[2] == ' ') continue;
      std::istringstream words(line);
      for (std::string word; words >> word;) {
        const bool more = word.ends_with(',');
        names.push_back(more ? word.substr(0, word.size() - 1) : word);
        if (!more) break;
      }
    }
    return names;
  }

  void expect_own_words(const Words& words) const {
    const Outcome outcome = pupflow(words);
    const std::string shown = testing::PrintToString(words);
    EXPECT_THAT((std::array{0, 2, 4, 5}), testing::Contains(outcome.code)) << shown;
    if (outcome.code == 0) return;
    EXPECT_THAT(outcome.err, testing::MatchesRegex("pupflow: [^\n]+\n")) << shown;
    for (const char* of_library : kOfLibraries) {
      EXPECT_THAT(outcome.err, Not(HasSubstr(of_library))) << shown;
    }
  }

  test::Scratch scratch_;
  fs::path work_;
};

TEST_F(CliWords, AreItsOwnForEveryOptionAndValue) {
  // Everywhere; and where an option is met first, since its check is the same in all verbs.
  const Words usual{"abc"};
  const Words all_values{"",       "abc",      "-1", "1e400", "nan", "99999999999999999999",
                         "folder", "none.toml"};
  std::set<std::string> met;
  int tried = 0;
  for (const std::string& verb : names_in("Verbs", pupflow({"--help"}).out)) {
    const std::string help = pupflow({verb, "--help"}).out;
    const auto found = kSmall.find(verb);
    const auto words = [&](const std::string& option) {
      Words all{verb};
      for (std::size_t i = 0; found != kSmall.end() && i < found->second.size(); i += 2) {
        if (found->second[i] == option) continue;  // given twice would be all that it says
        all.insert(all.end(), {found->second[i], found->second[i + 1]});
      }
      if (!option.empty()) all.push_back(option);
      return all;
    };
    for (const std::string& option : names_in("Options", help)) {
      if (option == "-h" || option == "--help") continue;
      expect_own_words(words(option));
      for (const std::string& value : met.insert(option).second ? all_values : usual) {
        Words all = words(option);
        all.push_back(value);
        expect_own_words(all);
        ++tried;
      }
    }
    for (const std::string& value : all_values) {
      Words all = words("");
      all.push_back(value);
      expect_own_words(all);
    }
  }
  EXPECT_GT(tried, 500);
}

TEST_F(CliWords, SayThatAnOptionStandsWhereAValueShould) {
  const auto error = [&](const Words& words) { return pupflow(words).err; };
  EXPECT_THAT(error({"run", "--csv", "--pups", "p.csv"}),
              HasSubstr("--csv needs a value, and --pups is an option"));
  EXPECT_THAT(error({"sweep", "--vary", "--out", "X"}),
              HasSubstr("--vary needs a value, and --out is an option"));
  EXPECT_THAT(error({"run", "-o"}), HasSubstr("-o needs a value"));
  EXPECT_THAT(error({"run", "--out", ""}), HasSubstr("--out: must not be empty"));
  EXPECT_THAT(error({"compare", "a", "b", "c"}), HasSubstr("SWEEP must be given twice"));
}

TEST_F(CliWords, AfterTwoDashesAreArguments) {
  const Words csv{"run", "--set", "pups=2", "--steps", "1", "--quiet", "--csv", "-x"};
  const auto with_csv = [&](const std::string& command) {
    fs::remove_all(work_);
    fs::create_directories(work_);
    EXPECT_EQ(test::run_program(program(), csv, work_.string()).code, 0);
    return test::run_program("/bin/sh", {"-c", "exec '" + program() + "' " + command},
                             work_.string());
  };
  EXPECT_EQ(with_csv("verify -- -x").code, 0);
  EXPECT_EQ(with_csv("info --json -- -x").code, 0);
  EXPECT_THAT(with_csv("verify ./-x -- --help").err, HasSubstr("--help: cannot read"));
  for (const auto& [command, extra] :
       std::map<std::string, std::string>{{"info -- -x bad.csv", "bad.csv"},
                                          {"info ./-x -- bad.csv", "bad.csv"},
                                          {"info ./-x -- --help", "--help"},
                                          {"run cold --steps 3 -- --set ta=9", "--set"},
                                          {"run cold -- --", "--"},
                                          {"params cold -- -x", "-x"},
                                          {"-- --help", "--help"},
                                          {"help run -- sweep", "sweep"}}) {
    const Outcome outcome = with_csv(command);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_THAT(outcome.out, testing::IsEmpty()) << command;
    EXPECT_THAT(outcome.err, testing::StartsWith("pupflow: unexpected argument '" + extra + "'"));
  }
  EXPECT_THAT(with_csv("merge none --out m -- nofolder").err, HasSubstr("none"));
  EXPECT_EQ(with_csv("compare none -- nofolder --quiet").code, 2);
  EXPECT_THAT(with_csv("--nope params").err, HasSubstr("unknown option '--nope'"));
  EXPECT_THAT(with_csv("run --ta 0.5").err, HasSubstr("--set ta=0.5"));
  EXPECT_THAT(with_csv("run cold --ta 0.5").err, HasSubstr("--set ta=0.5"));
}

TEST_F(CliWords, SayWhatHasNoEffect) {
  const std::map<std::string, Words> without{
      {"--record FILE", {"run", "--record-fields", "tb"}},
      {"--csv FILE or --pups FILE", {"run", "--every", "5"}},
      {"the summary", {"run", "--overlap", "--quiet"}},
      {"a summary for people", {"run", "--json", "--celsius"}},
      {"--record", {"sweep", "--vary", "ta=0,1", "--every", "5"}},
      {"--overlay trails", {"render", "--trail", "2"}},
      {"a picture;", {"render", "--movie", "f.mp4", "--dpi", "100"}},
      {"--movie FILE", {"render", "--fps", "20"}},
      {"--grid RANGE", {"render", "--panel", "200"}},
      {"a temperature", {"render", "--celsius", "--color-by", "group"}},
      {"the list", {"scenes", "cold", "--format", "json"}}};
  for (const auto& [what, words] : without) {
    const Outcome outcome = pupflow(words);
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(words);
    EXPECT_THAT(outcome.err, HasSubstr(": has no effect without " + what));
  }
}

TEST_F(CliWords, AFrameBehindTheLastStepIsRefusedWhereThatWasTyped) {
  EXPECT_THAT(pupflow({"render", "--at", "5", "--steps", "3"}).err, HasSubstr("at least 5"));
  EXPECT_EQ(pupflow({"render", "--at", "5", "--set", "steps=3"}).code, 2);
  EXPECT_EQ(pupflow({"render", "--at", "2000"}).code, 0);
  EXPECT_EQ(pupflow({"render", "--at", ""}).code, 2);
}

TEST_F(CliWords, TellWhatIsWrongWithAScene) {
  const std::map<std::string, std::string> problems{{"ta =", "a value is missing"},
                                                    {"ta 0.2", "a '=' is missing"},
                                                    {"ta = cold", "a text needs quotes"},
                                                    {"ta = 0.2 0.3", "more follows on the line"},
                                                    {"ta = 1\nta = 2", "given twice"},
                                                    {"start = \"column", "closing quote"},
                                                    {"steps = 99999999999999999999", "too large"},
                                                    {"ta = 1.", "is no number"},
                                                    {"[[at]", "heading of a table"},
                                                    {"= 3", "is no TOML"},
                                                    {"\xff\xfe", "UTF-8"}};
  for (const auto& [text, what] : problems) {
    fs::remove_all(work_);
    fs::create_directories(work_);
    const std::string scene = scratch_.file("scene.toml", text);
    const Outcome outcome = test::run_program(program(), {"run", scene}, work_.string());
    EXPECT_EQ(outcome.code, 2) << text;
    EXPECT_THAT(outcome.err,
                testing::MatchesRegex("pupflow: [^\n]*scene.toml:[0-9]+:[0-9]+: [^\n]+\n"));
    EXPECT_THAT(outcome.err, HasSubstr(what)) << text;
  }
}

}  // namespace
}  // namespace pupflow
