// The manual in its forms: help, pages, man pages, completion of shells.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "program.h"
#include "pupflow/parameters.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using test::Outcome;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class CliManual : public testing::Test {
 protected:
  std::string said(const std::vector<std::string>& arguments) const {
    const Outcome outcome =
        test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }

  /// The verbs, from the list that help shows.
  std::vector<std::string> verbs() const {
    std::istringstream help(said({"--help"}));
    std::vector<std::string> names;
    std::string line;
    while (std::getline(help, line) && line != "Verbs:") {
    }
    while (std::getline(help, line) && !line.empty()) {
      if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    return names;
  }

  /// What bash offers after these words, the last of which is being typed.
  std::vector<std::string> offered(const std::string& words) const {
    scratch_.file("completion", said({"help", "--format", "bash"}));
    const std::string script = "source completion; COMP_WORDS=(" + words +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); compopt() { :; }; "
                               "_pupflow; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const Outcome outcome =
        test::run_program("/bin/bash", {"-c", script}, scratch_.folder().string());
    EXPECT_EQ(outcome.err, "");
    std::istringstream lines(outcome.out);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return all;
  }

  test::Scratch scratch_;
};

TEST_F(CliManual, HelpFitsEightyColumnsAndEndsWithExamplesAndExitCodes) {
  EXPECT_GT(verbs().size(), 15u);
  for (const std::string& verb : verbs()) {
    const std::string help = said({verb, "--help"});
    EXPECT_EQ(help, said({"help", verb}));
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
      std::size_t width = 0;
      for (const char c : line) width += (c & '\xC0') != '\x80' ? 1 : 0;
      EXPECT_LE(width, 80u) << line;
    }
    const std::string end = help.substr(std::min(help.find("\nExamples:\n"), help.size()));
    EXPECT_THAT(end, HasSubstr("\nExit codes:\n  0    done\n")) << verb;
    std::size_t examples = 0;
    for (std::size_t at = 0; (at = end.find("\n  pupflow ", at)) != std::string::npos; ++at) {
      ++examples;
    }
    EXPECT_GE(examples, 2u) << verb;
  }
}

TEST_F(CliManual, AnUnknownVerbOrFormIsRefused) {
  const auto refused = [&](const std::vector<std::string>& arguments) {
    const Outcome outcome =
        test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_THAT(refused({"help", "rnu"}), HasSubstr("did you mean 'run'?"));
  EXPECT_THAT(refused({"help", "run", "--format", "pdf"}), HasSubstr("none of text"));
  EXPECT_THAT(refused({"help", "run", "--format", "bash"}), HasSubstr("leave out 'run'"));
  EXPECT_THAT(refused({"scenes", "pils"}), HasSubstr("did you mean 'pile'?"));
}

TEST_F(CliManual, PagesHaveEveryOption) {
  for (const char* form : {"text", "markdown", "man"}) {
    const std::string page = said({"help", "run", "--format", form});
    for (const char* part : {"csv", "NAME=VALUE", "130", "cold"}) {
      EXPECT_THAT(page, HasSubstr(part)) << form;
    }
  }
  EXPECT_THAT(said({"help", "run", "--format", "man"}), StartsWith(".TH PUPFLOW-RUN 1 "));
  EXPECT_THAT(said({"help", "--format", "zsh"}), StartsWith("#compdef pupflow\n"));
}

TEST_F(CliManual, BashCompletesVerbsOptionsParametersFieldsAndScenes) {
  EXPECT_THAT(offered("pupflow ren"), ElementsAre("render"));
  EXPECT_THAT(offered("pupflow run --rec"),
              ElementsAre("--record", "--record-every", "--record-from", "--record-fields"));
  std::vector<std::string> settings;
  for (const Parameter& parameter : parameters())
    settings.push_back(std::string(parameter.name) + '=');
  EXPECT_EQ(offered("pupflow run --set ''"), settings);
  EXPECT_THAT(offered("pupflow sweep --vary alp"), ElementsAre("alpha="));
  EXPECT_THAT(offered("pupflow render --color-by gro"), ElementsAre("group", "group_size"));
  EXPECT_THAT(offered("pupflow render --quality ''"), ElementsAre("fast", "normal", "print"));
  EXPECT_THAT(offered("pupflow live c"), Contains("critical"));
  EXPECT_THAT(offered("pupflow run -q ''"), Contains("completion")) << "files, too";
}

TEST_F(CliManual, ScenesAreListedAndPrinted) {
  const std::string list = said({"scenes"});
  EXPECT_THAT(list, HasSubstr("cold "));
  EXPECT_THAT(list, HasSubstr("they steer to each other"));
  said({"scenes", "cold", "--out", "mine.toml"});
  EXPECT_EQ(test::contents(scratch_.path("mine.toml")), said({"scenes", "cold"}));
  said({"run", "mine.toml", "--steps", "1", "-q"});
}

}  // namespace
}  // namespace pupflow
