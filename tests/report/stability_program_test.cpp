// pupflow report stability and extreme runs, from the command line to the files.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <sstream>

#include "app/io/csv.h"
#include "app/io/png.h"
#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow::report {
namespace {

using pupflow::test::contents;
using pupflow::test::Outcome;
using pupflow::test::Scratch;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The rows of a CSV file as maps from column to cell.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& path) {
  std::istringstream text(contents(path));
  std::vector<std::string> names;
  std::vector<std::map<std::string, std::string>> rows;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (names.empty()) {
      names = row;
      continue;
    }
    EXPECT_EQ(row.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) rows.back()[names[i]] = row[i];
  }
  return rows;
}

/// Finds cells of the maps in a report's folder.
class Maps {
 public:
  explicit Maps(std::string folder) : folder_(std::move(folder)) {}

  /// The row of one cell.
  std::map<std::string, std::string> row(const std::string& map, const std::string& x,
                                         const std::string& y, const std::string& method) const {
    for (auto& row : rows_of(folder_ + "/" + map + ".csv")) {
      const std::string cell =
          names(x) + "=" + row[names(x)] + " " + names(y) + "=" + row[names(y)];
      if (cell == x + " " + y && row["method"] == method) return row;
    }
    ADD_FAILURE() << map << " has no cell " << x << " " << y;
    return {};
  }

  std::string verdict(const std::string& map, const std::string& x, const std::string& y,
                      const std::string& method) const {
    return row(map, x, y, method)["class"];
  }

 private:
  static std::string names(const std::string& setting) {
    return setting.substr(0, setting.find('='));
  }
  std::string folder_;
};

void expect_page_and_pictures(const std::string& folder) {
  const std::string page = contents(folder + "/report.md");
  EXPECT_THAT(
      page, AllOf(HasSubstr("`pupflow report stability --quick`"), HasSubstr("## Classes"),
                  HasSubstr("## Maps"), HasSubstr("## Extreme scenes"), HasSubstr("| predictive |"),
                  HasSubstr("| euler |"), Not(HasSubstr("| NO |"))));
  for (const std::string map : {"alpha_beta", "step_alpha", "step_gravity", "step_refinement",
                                "drive_pups", "points", "radii", "step_k1", "step_k2"}) {
    EXPECT_THAT(page, HasSubstr("](" + map + ".png)"));
    EXPECT_EQ(io::read_png(folder + "/" + map + ".png").width, 980);
    EXPECT_THAT(contents(folder + "/" + map + ".svg"), HasSubstr("</svg>"));
    EXPECT_FALSE(io::read_csv_header(folder + "/" + map + ".csv").empty());
  }
}

void expect_known_cells(const Maps& maps) {
  EXPECT_EQ(maps.verdict("alpha_beta", "alpha=0.7", "beta=0.5", "predictive"), "stable");
  EXPECT_EQ(maps.verdict("alpha_beta", "alpha=1", "beta=0", "predictive"), "stable");
  EXPECT_EQ(maps.verdict("alpha_beta", "alpha=0.7", "beta=1", "predictive"), "inverted");
  auto lost = maps.row("alpha_beta", "alpha=0.7", "beta=0.5", "explicit");
  EXPECT_EQ(lost["class"], "diverged");
  EXPECT_EQ(lost["bad_stage"], "predict");
  EXPECT_GT(std::stoi(lost["bad_step"]), 100);
  EXPECT_EQ(maps.verdict("step_alpha", "dt=0.01", "alpha=0.7", "predictive"), "stable");
  EXPECT_EQ(maps.verdict("step_alpha", "dt=1", "alpha=0.7", "predictive"), "escaped");
  EXPECT_EQ(maps.verdict("step_alpha", "dt=0.1", "alpha=0.7", "predictive"), "sunk");
  EXPECT_EQ(maps.verdict("step_refinement", "dt=0.005", "alpha=0.7", "consistent"), "stable");
  EXPECT_EQ(maps.verdict("step_refinement", "dt=0.005", "alpha=1", "consistent"), "refused");
  EXPECT_EQ(maps.verdict("points", "face_points=7", "point_over_pup=0.2", "nearest"), "stable");
  EXPECT_EQ(maps.verdict("radii", "pup_over_arena=0.125", "pups=12", "nearest"), "stable");
  EXPECT_EQ(maps.verdict("step_gravity", "dt=0.01", "gravity=10", "predictive"), "stable");
  EXPECT_NE(maps.verdict("step_gravity", "dt=0.01", "gravity=1e+05", "predictive"), "stable");
  EXPECT_EQ(maps.verdict("drive_pups", "drive=1", "pups=12", "predictive"), "stable");
  EXPECT_EQ(maps.verdict("drive_pups", "drive=1000", "pups=1", "predictive"), "escaped");
}

/// Seeds that disagree are counted and named, and what is warned of stands in the row.
void expect_seeds_and_warnings(const std::string& folder) {
  for (auto& row : rows_of(folder + "/step_alpha.csv")) {
    const int agree = std::stoi(row["agree"]);
    EXPECT_EQ(row["seeds"], "3");
    EXPECT_GE(agree, 1);
    EXPECT_EQ(agree == 3, row["other"] == "-") << row["classes"];
    EXPECT_THAT(row["classes"], HasSubstr(row["class"]));
    if (row["class"] == "sunk") {
      EXPECT_THAT(row["warnings"], HasSubstr("under the floor"));
    }
    if (row["class"] == "stable") {
      EXPECT_GT(std::stod(row["kinetic"]), 0);
    }
  }
}

/// Forward Euler rings where k1 h is above 1 and diverges where it is above 2; the exact rule
/// never.
void expect_heat_as_in_theory(const std::string& path) {
  for (auto& row : rows_of(path)) {
    const double kh = std::stod(row["k1"]) * std::stod(row["dt"]);
    const std::string expected = row["method"] == "exact" || kh < 1 ? "stable"
                                 : kh < 2                           ? "ringing"
                                                                    : "diverged";
    EXPECT_EQ(row["class"], expected) << row["method"] << ' ' << kh;
  }
}

TEST(StabilityProgram, WritesAPageWithMapsAndScenesThatHasTheKnownCellsRight) {
  const Scratch scratch;
  const Outcome outcome = pupflow::test::run_program(
      PUPFLOW_PROGRAM, {"report", "stability", "--quick", "--threads", "2", "--out", "r"},
      scratch.folder().string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "report in r/report.md\n");
  expect_page_and_pictures(scratch.path("r"));
  expect_known_cells(Maps(scratch.path("r")));
  expect_heat_as_in_theory(scratch.path("r/step_k1.csv"));
  expect_seeds_and_warnings(scratch.path("r"));
}

TEST(StabilityProgram, KeepsFinishedMapsWhenInterrupted) {
  const Scratch scratch;
  pupflow::test::Running running(PUPFLOW_PROGRAM, {"report", "stability", "--quick", "--out", "r"},
                                 scratch.folder().string());
  while (!std::filesystem::exists(scratch.path("r/alpha_beta.png"))) ::usleep(20000);
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_EQ(rows_of(scratch.path("r/alpha_beta.csv")).size(), 24u);
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r/report.md")));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r/step_k1.csv")));
}

/// One extreme run from the command line.
struct ExtremeRun {
  std::vector<std::string> set;
  int code;
  std::string said;  // on standard error
};

TEST(ExtremeRuns, WorkOrSayWhyNotAndKeepTheRowsBefore) {
  const ExtremeRun runs[] = {
      {{"pups=0"}, 0, ""},
      {{"pups=1"}, 0, ""},
      {{"gravity=1e5"}, 0, ""},
      {{"alpha=1", "beta=1"}, 0, ""},
      {{"alpha=0", "beta=0"}, 0, ""},
      {{"ta=-1e6"}, 0, ""},
      {{"ta=1e6", "precision=float"}, 0, ""},
      {{"k1=0", "k2=0"}, 0, ""},
      {{"face_points=2"}, 0, ""},
      {{"dt=1e-8"}, 0, ""},
      {{"dt=1e-8", "precision=float"}, 2, "must be at least 1e-04 with precision = float"},
      {{"dt=1"}, 3, "escaped from the arena at step "},
      {{"drive=1e5"}, 3, "escaped from the arena at step 2, stage shape_match, pup 0"},
      {{"point_radius=0.5", "contact=sum"}, 3, "diverged at step "},
      {{"heat=euler", "k1=500"}, 3, "diverged at step 5, stage heat, pup "},
      {{"integrator=explicit"}, 3, "diverged at step "},
  };
  for (const ExtremeRun& run : runs) {
    const Scratch scratch;
    std::vector<std::string> words{"run", "--quiet", "--steps", "400", "--csv", "m.csv"};
    for (const std::string& set : run.set) words.insert(words.end(), {"--set", set});
    const Outcome outcome =
        pupflow::test::run_program(PUPFLOW_PROGRAM, words, scratch.folder().string());
    EXPECT_EQ(outcome.code, run.code) << run.set[0] << ": " << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(run.said)) << run.set[0];
    if (run.code == 2) continue;
    const std::string csv = contents(scratch.path("m.csv"));
    EXPECT_THAT(csv, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf")))) << run.set[0];
    const std::size_t rows = rows_of(scratch.path("m.csv")).size();
    if (run.code == 0) {
      EXPECT_EQ(rows, 400u) << run.set[0];
    } else {
      EXPECT_THAT(outcome.err, HasSubstr(" step " + std::to_string(rows + 1) + ",")) << run.set[0];
    }
  }
}

}  // namespace
}  // namespace pupflow::report
