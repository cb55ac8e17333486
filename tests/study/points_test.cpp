// Points from a table and from a latin hypercube, by the program.
#include <gmock/gmock.h>

#include <set>

#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class Points : public SweepProgram {};

TEST_F(Points, OfATableAreItsRowsInTheirOrder) {
  scratch_.file("design.csv", "beta,ta\n0.5,0.9\n0,0.1\n0.5,0.9\n");
  expect(0, small("sweep", {"--design", "design.csv", "--seeds", "2", "--out", "s"}));
  EXPECT_THAT(names_of(path("s")),
              ElementsAre("design.csv", "manifest.toml", "runs.csv", "summary.csv", "sweep.gp",
                          "sweep.png", "sweep.svg"));
  const auto runs = rows_of(path("s/runs.csv")), points = rows_of(path("s/summary.csv"));
  ASSERT_THAT(runs, SizeIs(6));
  ASSERT_THAT(points, SizeIs(3));
  EXPECT_THAT(Words(runs[2].begin(), runs[2].begin() + 2), ElementsAre("0", "0.1"));
  EXPECT_THAT(Words(points[2].begin(), points[2].begin() + 3), ElementsAre("0.5", "0.9", "2"));
  std::set<std::string> seeds;
  for (const Words& row : runs) seeds.insert(row[2]);
  EXPECT_THAT(seeds, SizeIs(6));
  expect(0, {"run", "--like", "s/runs.csv", "--quiet"});
  // The folder keeps the table: it gives the same sweep.
  const Outcome again =
      pupflow(small("sweep", {"--design", "s/design.csv", "--seeds", "2", "--out", "s"}));
  EXPECT_THAT(again.out, HasSubstr("6 runs were there already"));
}

TEST_F(Points, OfATableMayHaveTheirSeeds) {
  scratch_.file("design.csv", "ta,seed\n0.9,5\n0.1,5\n0.9,6\n");
  expect(0, small("sweep", {"--design", "design.csv", "--out", "s"}));
  const auto runs = rows_of(path("s/runs.csv")), points = rows_of(path("s/summary.csv"));
  EXPECT_EQ(runs[2][1], "6");
  ASSERT_THAT(points, SizeIs(2));
  EXPECT_EQ(points[0][1], "2");
  EXPECT_EQ(points[1][1], "1");
  EXPECT_THAT(expect(2, small("sweep", {"--design", "design.csv", "--seeds", "2", "--out", "t"})),
              HasSubstr("--seeds: the column seed of design.csv"));
}

TEST_F(Points, OfAnotherTableAreAnotherSweep) {
  scratch_.file("design.csv", "ta\n0.9\n0.1\n");
  const Words words = small("sweep", {"--design", "design.csv", "--seeds", "1", "--out", "s"});
  expect(0, words);
  const auto files = files_of(path("s"));
  scratch_.file("design.csv", "ta\n0.9\n0.2\n");
  EXPECT_THAT(expect(2, words), AllOf(HasSubstr("another sweep"), HasSubstr("table = ")));
  EXPECT_EQ(files_of(path("s")), files);
}

TEST_F(Points, OfATableAreSharedAndMergedAndTakeMoreSeeds) {
  scratch_.file("design.csv", "ta,pups\n0.9,2\n0.1,3\n0.4,2\n");
  const auto sweep = [](const std::string& out, const std::string& seeds, const Words& more = {}) {
    Words words{"--design", "design.csv", "--seeds", seeds, "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return small("sweep", words);
  };
  expect(0, sweep("a", "3", {"--shard", "1/2"}));
  expect(0, sweep("b", "3", {"--shard", "2/2"}));
  expect(0, {"merge", "a", "b", "--out", "joined"});
  expect(0, sweep("whole", "3"));
  EXPECT_EQ(files_of(path("joined")), files_of(path("whole")));
  expect(0, sweep("joined", "12"));
  expect(0, sweep("more", "12"));
  EXPECT_EQ(files_of(path("joined")), files_of(path("more")));
}

TEST_F(Points, OfALatinHypercubeFollowFromTheBaseSeed) {
  const auto sweep = [](const std::string& out, const std::string& seeds, const std::string& base) {
    return small("sweep", {"--lhs", "6", "--vary", "ta=0:1", "--vary", "beta=0:0.9", "--seeds",
                           seeds, "--seed", base, "--out", out});
  };
  expect(0, sweep("a", "2", "1"));
  expect(0, sweep("b", "2", "1"));
  expect(0, sweep("c", "2", "2"));
  EXPECT_THAT(rows_of(path("a/runs.csv")), SizeIs(12));
  EXPECT_THAT(rows_of(path("a/summary.csv")), SizeIs(6));
  EXPECT_EQ(files_of(path("a")), files_of(path("b")));
  EXPECT_NE(rows_of(path("a/summary.csv"))[0][0], rows_of(path("c/summary.csv"))[0][0]);
  expect(0, sweep("a", "3", "1"));
  expect(0, sweep("d", "3", "1"));
  EXPECT_EQ(files_of(path("a")), files_of(path("d")));
  // --like takes its parameters, not its points.
  expect(0, {"sweep", "--like", "a/runs.csv", "--lhs", "6", "--vary", "ta=0:1", "--vary",
             "beta=0:0.9", "--seeds", "3", "--out", "e"});
  EXPECT_EQ(files_of(path("e")), files_of(path("a")));
}

TEST_F(Points, ThatAreWrongAreRefusedBeforeAnythingRuns) {
  scratch_.file("bad.csv", "ta,tb\n0.5,1\nx,1\n");
  scratch_.file("good.csv", "ta\n0.5\n");
  const std::pair<Words, const char*> wrong[] = {
      {{"--design", "bad.csv"}, "bad.csv:1:tb: unknown parameter 'tb'"},
      {{"--design", "bad.csv"}, "bad.csv:3:ta: ta = 'x'"},
      {{"--design", "good.csv", "--vary", "ta=0,1"}, "leave out --vary and --lhs"},
      {{"--design", "good.csv", "--lhs", "3"}, "leave out --vary and --lhs"},
      {{"--design", ""}, "--design"},
      {{"--lhs", "5"}, "--vary"},
      {{"--lhs", "5", "--vary", "ta=0:1:3"}, "name=from:to or name=a,b,c with --lhs"},
      {{"--lhs", "0", "--vary", "ta=0:1"}, "1 to 1000000"},
      {{"--vary", "ta=0,1", "--every", "5"}, "--every: has no effect without --record"},
      {{"--vary", "ta=0,1", "--record", "--every", "0"}, "--every"},
  };
  for (const auto& [words, said] : wrong) {
    EXPECT_THAT(expect(2, small("sweep", words)), HasSubstr(said));
  }
  EXPECT_THAT(expect(4, small("sweep", {"--design", "none.csv"})),
              HasSubstr("none.csv: cannot read"));
  EXPECT_EQ(scratch_.entries(), 2);
}

TEST_F(Points, ComparesTheFoldersOfTwoSweeps) {
  for (const std::string seed : {"1", "2"})
    expect(0, small("sweep",
                    {"--vary", "ta=0,1", "--seeds", "3", "--seed", seed, "--out", "s" + seed}));
  const Outcome folders = pupflow({"compare", "s1", "s2"});
  EXPECT_EQ(folders.code, 0) << folders.err;
  EXPECT_EQ(folders.out, pupflow({"compare", "s1/summary.csv", "s2"}).out);
  EXPECT_THAT(expect(2, {"compare", "s1", "."}), HasSubstr("no folder of a sweep"));
}

}  // namespace
}  // namespace pupflow::study::test
