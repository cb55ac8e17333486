#include <gmock/gmock.h>

#include "tests/study/small_design.h"
#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Merge : public SweepProgram {
 protected:
  static Words sweep(const std::string& out, const Words& more = {}) {
    Words words{"--vary", "ta=0:1:5", "--seeds", "4", "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return small("sweep", words);
  }
  void compute_shards() const {
    for (const std::string i : {"1", "2", "3"}) {
      expect(0, sweep("s" + i, {"--shard", i + "/3"}));
    }
  }
};

TEST_F(Merge, GivesTheBytesOfTheWholeSweep) {
  compute_shards();
  EXPECT_THAT(names_of(path("s1")), ElementsAre("manifest.toml", "runs.csv"));
  expect(0, {"merge", "s2", "s3", "s1", "--out", "merged"});  // in any order
  expect(0, sweep("whole"));
  EXPECT_EQ(files_of(path("merged")), files_of(path("whole")));
  const Outcome again = pupflow(sweep("merged"));
  EXPECT_THAT(again.out, HasSubstr("20 runs were there already"));
}

TEST_F(Merge, RefusesWhatIsNotCompleteOrDoesNotBelongTogether) {
  compute_shards();
  expect(0, sweep("other", {"--shard", "3/3", "--set", "beta=0.1"}));
  expect(0, sweep("half", {"--shard", "2/2"}));
  expect(0, sweep("whole"));
  const auto refused = [&](Words folders) {
    folders.insert(folders.begin(), "merge");
    folders.insert(folders.end(), {"--out", "merged"});
    return expect(2, folders);
  };
  EXPECT_THAT(refused({"s1", "s3"}), HasSubstr("1 of 3 shards is missing: 2; name all"));
  EXPECT_THAT(refused({"s1"}), HasSubstr("2 of 3 shards are missing: 2, 3; name all"));
  EXPECT_THAT(refused({"s1", "s2", "s2"}), HasSubstr("s2: is shard 2, and so is s2"));
  EXPECT_THAT(refused({"s1", "s2", "other"}),
              AllOf(HasSubstr("other: belongs to another sweep"), HasSubstr("'beta = 0.1'")));
  EXPECT_THAT(refused({"s1", "half", "s3"}), HasSubstr("is one of 2 shards"));
  EXPECT_THAT(refused({"whole", "s1", "s2", "s3"}), HasSubstr("is one of 3 shards"));
  EXPECT_THAT(refused({}), HasSubstr("FOLDER"));
  expect(2, {"merge", "s1", "s2", "s3"});  // --out is missing
  expect(4, {"merge", "s1", "nowhere", "s3", "--out", "merged"});
  EXPECT_FALSE(std::filesystem::exists(path("merged")));
}

TEST_F(Merge, RefusesUnfinishedAndDamagedShards) {
  compute_shards();
  const auto merge = [&] { return expect(2, {"merge", "s1", "s2", "s3", "--out", "merged"}); };
  const std::string runs = contents(path("s2/runs.csv"));
  scratch_.file("s2/runs.csv", runs.substr(0, runs.rfind('\n', runs.size() - 2) + 1));
  EXPECT_THAT(merge(), AllOf(HasSubstr("s2/runs.csv"), HasSubstr("holds 6 of 7 runs")));
  std::filesystem::remove(path("s2/runs.csv"));
  scratch_.file("s2/journal.csv", "");
  EXPECT_THAT(merge(), HasSubstr("s2: is not finished"));
}

TEST_F(Merge, NeedsNoMemoryForWhatIsMissing) {
  // Two of a million shards of a hundred million runs, with rows that no run came to.
  Design design = small_design({"ta=0:1:1000", "beta=0:0.9:10"}, 10'000);
  design.shard = {1, 1'000'000};
  const auto shard = [&](const std::string& folder) {
    std::filesystem::create_directory(path(folder));
    scratch_.file(folder + "/manifest.toml", manifest_text(design));
    std::vector<Row> rows;
    for (const std::int64_t run : design.own_runs()) rows.push_back(row_of(run, 1));
    write_runs(path(folder + "/runs.csv"), design, rows);
  };
  shard("one");
  design.shard.number = 3;
  shard("other");
  for (const std::string limit : {"ulimit -v 300000; exec", "exec"}) {
    const Outcome outcome = pupflow_behind(limit, {"merge", "one", "other", "--out", "merged"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              "pupflow: 999998 of 1000000 shards are missing: 2, 4, 5, 6, 7, 8, 9, 10, 11, 12, "
              "...; name all their folders\n");
  }
  EXPECT_FALSE(std::filesystem::exists(path("merged")));
}

TEST_F(Merge, DoesNotOverwriteAnotherSweepUnlessForced) {
  compute_shards();
  expect(0, sweep("s", {"--set", "beta=0.1"}));
  EXPECT_THAT(expect(2, {"merge", "s1", "s2", "s3", "--out", "s"}),
              HasSubstr("'beta = 0.1' there"));
  EXPECT_THAT(expect(2, {"merge", "s1", "s2", "s3", "--out", "s1"}), HasSubstr("'shard ="));
  expect(0, {"merge", "s1", "s2", "s3", "--out", "s", "--force", "--quiet"});
  expect(0, sweep("whole"));
  EXPECT_EQ(files_of(path("s")), files_of(path("whole")));
}

TEST_F(Merge, CarriesOnThatRunsWentWrong) {
  for (const std::string i : {"1", "2"}) {
    pupflow({"sweep", "--set", "pups=3", "--set", "face_points=3", "--set", "heat=euler", "--steps",
             "300", "--set", "discard=20", "--vary", "k1=0.9,500", "--seeds", "2", "--out", "s" + i,
             "--shard", i + "/2"});
  }
  EXPECT_THAT(expect(3, {"merge", "s1", "s2", "--out", "merged"}), HasSubstr("2 of 4 runs failed"));
}

}  // namespace
}  // namespace pupflow::study::test
