// A sweep of version 0.1.0 (tests/data/v0.1.0/sweep): its files are read, and running it again
// gives the same numbers.
#include <gmock/gmock.h>

#include "app/io/params_of_file.h"
#include "app/io/read_file.h"
#include "app/study/compare.h"
#include "app/study/results.h"
#include "pupflow/ensemble.h"

namespace pupflow::study {
namespace {

std::string old(const std::string& name) {
  return std::string(PUPFLOW_OLD_FILES) + "/sweep/" + name;
}

const std::string kNote = " was written by an older version; taking contact = sum, flow_lag = 1\n";

Design old_design() {
  ::testing::internal::CaptureStderr();
  Design design = parse_manifest(io::read_file(old("manifest.toml"), 1 << 16), "manifest.toml");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "pupflow: note: manifest.toml" + kNote);
  return design;
}

TEST(OldSweep, GivesTheSameNumbersAgain) {
  const Design design = old_design();
  const std::vector<Row> rows = read_runs(old("runs.csv"), design);
  ASSERT_EQ(rows.size(), 4U);
  for (const Row& row : rows) {
    const auto result = run_to_end(design.params_of(row.run), [] { return false; });
    EXPECT_EQ(row_text(design, make_row(row.run, *result)), row_text(design, row));
  }
}

TEST(OldSweep, IsCompared) {
  const Comparison same = compare_summaries(old("summary.csv"), old("summary.csv"));
  EXPECT_EQ(same.key.size(), 2U);
  EXPECT_THAT(same.observables, ::testing::Contains("mean_tb"));
  EXPECT_EQ(same.rms, 0);
}

TEST(OldSweep, GivesItsParameters) {
  ::testing::internal::CaptureStderr();
  const Params params = io::params_of_file(old("runs.csv"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "pupflow: note: " + old("runs.csv") + kNote);
  EXPECT_EQ(params, old_design().base);
}

}  // namespace
}  // namespace pupflow::study
