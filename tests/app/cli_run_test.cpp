// pupflow run, as a user sees it.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include "app/io/params_of_file.h"
#include "app/io/provenance.h"
#include "app/io/scene_file.h"
#include "app/io/text.h"
#include "program.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using test::contents;
using test::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class CliRun : public testing::Test {
 protected:
  Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }

  /// The lines of a CSV file that are no comments.
  std::vector<std::string> rows(const std::string& name) const {
    std::vector<std::string> lines;
    std::istringstream text(contents(scratch_.path(name)));
    for (std::string line; std::getline(text, line);) {
      if (!line.starts_with('#')) lines.push_back(line);
    }
    return lines;
  }

  std::string last_line(const std::string& name) const {
    const std::string text = contents(scratch_.path(name));
    const std::size_t begin = text.rfind('\n', text.size() - 2) + 1;
    return text.substr(begin, text.size() - 1 - begin);
  }

  test::Scratch scratch_;
};

TEST_F(CliRun, WritesBothFilesWithTheirColumns) {
  const Outcome outcome =
      pupflow({"run", "--set", "pups=3", "--steps", "7", "--csv", "m.csv", "--pups", "p.csv"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("status  fine"));
  const auto metrics = rows("m.csv"), pups = rows("p.csv");
  ASSERT_EQ(metrics.size(), 1U + 7);
  ASSERT_EQ(pups.size(), 1U + 3 * 7);
  EXPECT_EQ(metrics[0], "step,time,mean_tb,huddling,groups,largest,flow,membership_flow");
  EXPECT_EQ(pups[0], "step,pup,x,y,z,tb,exposed,heading");
  EXPECT_THAT(metrics[1], StartsWith("1,0.01,"));
  EXPECT_THAT(metrics[7], StartsWith("7,"));
  EXPECT_THAT(pups[1], StartsWith("1,0,"));
  EXPECT_THAT(pups[21], StartsWith("7,2,"));
  EXPECT_EQ(scratch_.entries(), 2);
}

TEST_F(CliRun, EveryThinsTheRowsWithoutChangingThem) {
  ASSERT_EQ(pupflow({"run", "cold", "--steps", "60", "--quiet", "--csv", "all.csv"}).code, 0);
  ASSERT_EQ(
      pupflow({"run", "cold", "--steps", "60", "--quiet", "--csv", "some.csv", "--every", "20"})
          .code,
      0);
  const auto all = rows("all.csv");
  EXPECT_THAT(rows("some.csv"), ElementsAre(all[0], all[20], all[40], all[60]));
}

TEST_F(CliRun, LikeMakesTheSameFileAgain) {
  ASSERT_EQ(pupflow({"run", "critical", "--seed", "7", "--set", "tp=0.61", "--steps", "50",
                     "--precision", "float", "--quiet", "--csv", "a.csv"})
                .code,
            0);
  ASSERT_EQ(pupflow({"run", "--like", "a.csv", "--quiet", "--csv", "b.csv"}).code, 0);
  EXPECT_EQ(contents(scratch_.path("a.csv")), contents(scratch_.path("b.csv")));
  ASSERT_EQ(pupflow({"run", "--like", "a.csv", "--seed", "8", "--quiet", "--csv", "c.csv"}).code,
            0);
  EXPECT_NE(rows("a.csv"), rows("c.csv"));
}

TEST_F(CliRun, ThreadsChangeNoByte) {
  for (const char* threads : {"1", "2", "5"}) {
    const Outcome outcome =
        pupflow({"run", "--set", "pups=130", "--set", "start=carpet", "--set", "arena_radius=5",
                 "--set", "face_points=4", "--steps", "60", "--threads", threads, "--pups",
                 std::string(threads) + ".csv"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  EXPECT_EQ(contents(scratch_.path("2.csv")), contents(scratch_.path("1.csv")));
  EXPECT_EQ(contents(scratch_.path("5.csv")), contents(scratch_.path("1.csv")));
}

TEST_F(CliRun, DefaultThenSceneThenSetThenShortcut) {
  scratch_.file("s.toml", "ta = 0.1\ntp = 0.1\nsteps = 2\nseed = 2\n");
  ASSERT_EQ(pupflow({"run", "--set", "tp=0.2", "--set", "seed=3", "s.toml", "--seed", "4", "--csv",
                     "m.csv", "--quiet"})
                .code,
            0);
  Params expected;
  expected.ambient_temperature = 0.1;
  expected.preferred_temperature = 0.2;
  expected.steps = 2;
  expected.seed = 4;
  EXPECT_EQ(io::params_of_file(scratch_.path("m.csv")), expected);
}

TEST_F(CliRun, NoStepsGiveAFileWithoutRows) {
  const Outcome outcome = pupflow({"run", "--steps", "0", "--csv", "m.csv"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("no means"));
  EXPECT_EQ(rows("m.csv").size(), 1U);
}

TEST_F(CliRun, SaysWhyThereAreNoMeans) {
  EXPECT_THAT(pupflow({"run", "--steps", "5"}).out,
              HasSubstr("no means: the run ended at step 5, and discard = 500"));
  EXPECT_THAT(pupflow({"run", "--steps", "6", "--set", "discard=5"}).out,
              HasSubstr("means over steps 6 to 6"));
}

TEST_F(CliRun, PrintsMeansForPeople) {
  const Outcome outcome = pupflow({"run", "--steps", "40", "--set", "discard=38"});
  Params params;
  params.steps = 40;
  params.discard = 38;
  Simulation simulation(params);
  Observer observer(simulation);
  RunMeans means(params.discard);
  while (simulation.steps_done() < params.steps && simulation.step().ok()) {
    means.add(simulation, observer.observe(simulation));
  }
  std::istringstream after(outcome.out.substr(outcome.out.find("body temperature T_b") + 20));
  double printed = 0;
  after >> printed;
  EXPECT_NEAR(printed, means.means().mean_tb, 5e-5) << "four digits";
  const std::string degrees =
      pupflow({"run", "--steps", "40", "--set", "discard=38", "--celsius"}).out;
  EXPECT_THAT(degrees, HasSubstr("T_a 0.4 (24.7 °C), seed 1"));
  EXPECT_THAT(degrees, HasSubstr(io::formatted("(%.1f °C)\n", 37 / 0.6 * means.means().mean_tb)));
}

TEST_F(CliRun, FlowLagIsThatOfRowsMeansAndWhatTheFileCarries) {
  const std::vector<std::string> words{"run",        "--steps", "40",    "--set", "discard=20",
                                       "--flow-lag", "10",      "--csv", "m.csv"};
  const Outcome whole = pupflow(words);
  EXPECT_EQ(whole.code, 0) << whole.err;
  EXPECT_THAT(whole.out, HasSubstr("pup flow, lag 10 "));
  EXPECT_THAT(contents(scratch_.path("m.csv")), HasSubstr("# flow_lag = 10\n"));
  const auto all = rows("m.csv");
  EXPECT_THAT(all[9], HasSubstr(",nan,"));  // no step has one ten before it
  EXPECT_THAT(all[10], Not(HasSubstr("nan")));
  // Rows further apart than the lag, and means alone, come to the same.
  std::vector<std::string> sparse = words;
  sparse.back() = "s.csv";
  sparse.insert(sparse.end(), {"--every", "17"});
  EXPECT_THAT(pupflow(sparse).out, HasSubstr(whole.out.substr(whole.out.find("means over"))));
  EXPECT_EQ(rows("s.csv")[1], all[17]);
  EXPECT_EQ(rows("s.csv")[2], all[34]);
  sparse.push_back("--quiet");  // no means
  sparse[8] = "q.csv";
  EXPECT_EQ(pupflow(sparse).code, 0);
  EXPECT_EQ(rows("q.csv"), rows("s.csv"));
  EXPECT_THAT(pupflow({"run", "--like", "m.csv"}).out, HasSubstr("pup flow, lag 10 "));
  EXPECT_THAT(pupflow({"run", "--flow-lag", "0"}).err,
              HasSubstr("--flow-lag: flow_lag = 0: lag of"));
}

TEST_F(CliRun, TellsTheOverlapOnlyWhereAsked) {
  const std::vector<std::string> words{"run", "cold", "--steps", "600"};
  const std::string plain = pupflow(words).out;
  EXPECT_THAT(plain, Not(HasSubstr("overlap")));
  std::vector<std::string> asked = words;
  asked.emplace_back("--overlap");
  const Outcome outcome = pupflow(asked);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("overlap of bodies, every 10th of these steps\n"));
  const auto value = [&](const std::string& name) {
    const std::size_t at = outcome.out.find(name);
    EXPECT_NE(at, std::string::npos) << name;
    return std::stod(outcome.out.substr(at + name.size()));
  };
  EXPECT_GT(value("nearest centres apart"), 0.25);
  EXPECT_LT(value("nearest centres apart"), 0.6);
  EXPECT_LE(value("closest ever"), value("nearest centres apart"));
  EXPECT_GT(value("points inside another"), 0.01);
  EXPECT_LT(value("points inside another"), 0.5);
  EXPECT_LT(value("exposed share of those"), 1);
  const auto hash = [](const std::string& text) { return text.substr(text.find("hash")); };
  EXPECT_EQ(hash(outcome.out), hash(plain));
}

TEST_F(CliRun, RefusesBeforeItStarts) {
  scratch_.file("m.csv", "precious");
  // So many steps would not end: refusing comes first.
  const Outcome outcome = pupflow({"run", "--steps", "1000000000", "--csv", "m.csv"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, StartsWith("pupflow: m.csv: exists already; use --force"));
  EXPECT_EQ(contents(scratch_.path("m.csv")), "precious");
  EXPECT_EQ(pupflow({"run", "--steps", "2", "--csv", "m.csv", "--force"}).code, 0);
  EXPECT_EQ(rows("m.csv").size(), 3U);
  EXPECT_EQ(pupflow({"run", "--csv", "x.csv", "--pups", "./x.csv"}).code, 2);
  EXPECT_EQ(pupflow({"run", "--csv", "m.csv/x.csv"}).code, 4);
  EXPECT_EQ(pupflow({"run", "--csv", ""}).code, 2);
  EXPECT_EQ(scratch_.entries(), 1);
}

TEST_F(CliRun, ReportsAFullDisk) {
  const Outcome outcome = pupflow({"run", "--steps", "3", "--quiet", "--csv", "/dev/full"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("/dev/full: cannot write"));
}

TEST_F(CliRun, StandardOutputCarriesTheRowsAlone) {
  const Outcome outcome = pupflow({"run", "--steps", "2", "--csv", "-"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, StartsWith("# Software = pupflow"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("status")));
  EXPECT_THAT(outcome.err, HasSubstr("status  fine"));
}

TEST_F(CliRun, BadNumbersKeepTheRowsBefore) {
  const Outcome outcome = pupflow({"run", "--set", "heat=euler", "--set", "k1=500", "--csv",
                                   "m.csv", "--pups", "p.csv", "--quiet"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, testing::MatchesRegex("pupflow: [^\n]+ at step [0-9]+, stage [^\n]+\n"));
  const std::string reason = outcome.err.substr(9, outcome.err.size() - 10);
  EXPECT_EQ(last_line("m.csv"), "# ended early: " + reason);
  EXPECT_EQ(last_line("p.csv"), "# ended early: " + reason);
  const auto metrics = rows("m.csv");
  EXPECT_THAT(reason, HasSubstr("step " + std::to_string(metrics.size()) + ","));
  EXPECT_EQ(rows("p.csv").size(), 1 + 12 * (metrics.size() - 1));
}

TEST_F(CliRun, AWarningIsInTheSummaryAndTheLastComment) {
  const Outcome outcome = pupflow({"run", "--set", "drive=60", "--set", "face_points=3", "--steps",
                                   "200", "--csv", "m.csv", "--pups", "p.csv"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("\nstatus  fine\nwarning outside the wall from step "));
  EXPECT_THAT(outcome.out, HasSubstr("\nwarning hanging in the air from step "));
  EXPECT_THAT(contents(scratch_.path("m.csv")),
              HasSubstr("\n# warning: outside the wall from step"));
  for (const char* name : {"m.csv", "p.csv"}) {
    EXPECT_THAT(last_line(name), StartsWith("# warning: hanging in the air from step 150 pup "));
  }
}

TEST_F(CliRun, ShippedScenesGiveNoWarning) {
  for (const io::ShippedScene& scene : io::shipped_scenes()) {
    const std::string name(scene.name);
    const Outcome outcome = pupflow({"run", name, "--steps", "250", "--set", "face_points=3"});
    EXPECT_EQ(outcome.code, 0) << name << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("status  fine\nhash")) << name;
  }
}

class CliRunSignal : public CliRun, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(All, CliRunSignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_P(CliRunSignal, KeepsTheRowsDone) {
  test::Running running(PUPFLOW_PROGRAM,
                        {"run", "--steps", "1000000000", "--csv", "m.csv", "--quiet"},
                        scratch_.folder().string());
  while (scratch_.entries() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  running.signal(GetParam());
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, testing::MatchesRegex("pupflow: interrupted after step [0-9]+\n"));
  const std::string reason = outcome.err.substr(9, outcome.err.size() - 10);
  EXPECT_EQ(last_line("m.csv"), "# ended early: " + reason);
  EXPECT_EQ(reason, "interrupted after step " + std::to_string(rows("m.csv").size() - 1));
}

TEST_F(CliRun, WhatIsPrintedToAClosedStreamDoesNotLandInAFile) {
  const auto run = [&](const std::string& file, const std::string& closed) {
    const std::string command =
        "'" PUPFLOW_PROGRAM "' run cold --steps 9000 --every 500 --csv " + file + " " + closed;
    return test::run_program("/bin/sh", {"-c", command}, scratch_.folder().string()).code;
  };
  ASSERT_EQ(run("plain.csv", ""), 0);
  EXPECT_EQ(run("closed.csv", "2>&-"), 0);
  run("all.csv", "<&- >&- 2>&-");
  const std::string plain = test::contents(scratch_.path("plain.csv"));
  EXPECT_EQ(test::contents(scratch_.path("closed.csv")), plain);
  EXPECT_EQ(test::contents(scratch_.path("all.csv")), plain);
}

TEST_F(CliRun, OutputDoesNotDependOnWhatIsWatched) {
  const auto hash = [](const Outcome& outcome) {
    return outcome.out.substr(outcome.out.find("hash"));
  };
  const Outcome plain = pupflow({"run", "cold", "--steps", "80"});
  const Outcome watched = pupflow({"run", "cold", "--steps", "80", "--set", "discard=10", "--csv",
                                   "m.csv", "--pups", "p.csv", "--every", "7"});
  EXPECT_EQ(hash(plain), hash(watched));
}

}  // namespace
}  // namespace pupflow
