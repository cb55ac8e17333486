#include "app/study/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/failing.h"
#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using io::ExitCode;
using pupflow::test::failure_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Design table(const std::string& text) {
  Design design = test::small_design({}, 3);
  parse_table(text, "runs.csv", design);
  return design;
}

std::string refused(const std::string& text) {
  return failure_of(ExitCode::bad_input, [&] { table(text); });
}

TEST(ATable, HasAPointInEachRow) {
  const Design design = table("ta,heading,pups\n0.5,body,4\n0.1,course,2\n0.5,body,4\n");
  EXPECT_EQ(design.points(), 3);
  EXPECT_EQ(design.runs(), 9);
  EXPECT_THAT(design.values_at(1), ElementsAre(0.1, 0, 2));
  EXPECT_EQ(design.params_of(8).pups, 4);
  EXPECT_EQ(design.params_of(8).seed, run_seed(1, 22));
  EXPECT_EQ(design.params_of(8).face_points, 3) << "of the base";
  check_design(design);
}

TEST(ATable, MayGiveTheSeeds) {
  const Design design = table("seed,ta\n7,0.5\n9007199254740991,0.5\n7,0.1\n");
  EXPECT_EQ(design.runs(), 3);
  EXPECT_EQ(design.seed_of(1), 9007199254740991);
  EXPECT_EQ(design.params_of(2).seed, 7);
  EXPECT_EQ(table_text(design), "ta,seed\n0.5,7\n0.5,9007199254740991\n0.1,7\n");
  EXPECT_EQ(table("seed\n3\n4\n").runs(), 2);
}

TEST(ATable, IsReadAsOtherProgramsWriteIt) {
  const std::string plain = table_text(table("ta,pups\n0.5,4\n1e-05,2\n"));
  EXPECT_EQ(table_text(table("\xEF\xBB\xBF\"ta\",\"pups\"\r\n0.50,4.0\r\n1e-5,2\r\n")), plain);
  EXPECT_EQ(table_text(table("# made by hand\n\nta , pups\n 0.5,\t4\n# one more\n0.00001,2")),
            plain);
}

TEST(ATable, ReadsBackToTheSameDesign) {
  for (const char* text :
       {"ta,heading\n0.30000000000000004,body\n-1,course\n", "ta,seed\n1,2\n1,3\n"}) {
    const Design design = table(text), back = table(table_text(design));
    EXPECT_EQ(table_text(back), text);
    EXPECT_EQ(table_hash(back), table_hash(design));
  }
  EXPECT_NE(table_hash(table("ta\n0\n1\n")), table_hash(table("ta\n1\n0\n")));
  EXPECT_EQ(table_hash(table("ta\n0\n")).size(), 16u);
}

TEST(ATable, NamesEveryProblemWithItsPlace) {
  EXPECT_EQ(refused("ta,tb,pups,pups,alpha\n0.2,5,3,3,x\n0.2,6,3\n0.4,5,2.5,1,7\n"),
            "runs.csv:1:tb: unknown parameter 'tb'; did you mean 'tb0'?\n"
            "runs.csv:1:pups: this column is there twice\n"
            "runs.csv:2:alpha: alpha = 'x': rigidity must be 0 … 1\n"
            "runs.csv:3: has 3 values, and the header names 5 columns\n"
            "runs.csv:4:pups: pups = 2.5: pups must be a whole number 0 … 10000\n"
            "runs.csv:4:alpha: alpha = 7: rigidity must be 0 … 1");
  EXPECT_EQ(refused("steps\n\n100\n10\n"),
            "runs.csv:4: steps = 10 leaves no step for the means: it must exceed discard = 20");
  EXPECT_THAT(refused("pup_radius\n1.99\n"), HasSubstr("runs.csv:2: arena_radius"));
  EXPECT_EQ(refused("seed,ta\n1,0.5\n2,0.5\n1,0.50\n"), "runs.csv:4: is the same run as line 2");
}

TEST(ATable, ListsNoMoreThanAPageOfProblems) {
  std::string text = "ta\n";
  for (int i = 0; i < 1000; ++i) text += "x\n";
  const std::string said = refused(text);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 20);
  EXPECT_THAT(said, HasSubstr("more problems follow"));
}

TEST(ATable, WithoutRunsIsRefused) {
  for (const char* text : {"", "\n", "ta,beta\n", "# ta\n"}) {
    EXPECT_THAT(refused(text), HasSubstr("runs.csv: has no runs")) << text;
  }
}

}  // namespace
}  // namespace pupflow::study
