#include "app/study/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/app/failing.h"
#include "tests/study/small_design.h"
#include "tests/support/scratch.h"

namespace pupflow::study {
namespace {

using pupflow::test::contents;
using pupflow::test::Scratch;
using test::row_of;
using ::testing::ElementsAre;
using ::testing::Key;

class AJournal : public ::testing::Test {
 protected:
  /// A file with the runs 4, 0 and 2, in this order.
  void SetUp() override {
    Journal journal(path_, design_);
    for (const int run : {4, 0, 2}) journal.add(row_of(run, 0.1 * run));
  }
  const Scratch scratch_;
  const Design design_ = test::small_design({"ta=0,1"}, 3);
  const std::string path_ = scratch_.path("journal.csv");
};

TEST_F(AJournal, HasWhatWasAddedWhenOpenedAgain) {
  const Journal journal(path_, design_);
  EXPECT_THAT(journal.rows(), ElementsAre(Key(0), Key(2), Key(4)));
  EXPECT_EQ(journal.rows().at(4).means.mean_tb, 0.4);
}

TEST_F(AJournal, StaysValidWhenSeedsAreAdded) {
  const Design more = test::small_design({"ta=0,1"}, 14);
  const std::string before = contents(path_);
  EXPECT_THAT(Journal(path_, more).rows(), ElementsAre(Key(0), Key(2), Key(15)));
  EXPECT_EQ(contents(path_), before);
}

TEST_F(AJournal, KeepsWarnings) {
  Journal(path_, design_).add(test::warned_row(3, 1));
  const Journal journal(path_, design_);
  ASSERT_TRUE(journal.rows().contains(3));
  EXPECT_EQ(journal.rows().at(3).status, test::warned_row(3, 1).status);
}

TEST_F(AJournal, DropsALineThatWasCutOffAnywhere) {
  const std::string whole = contents(path_);
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t length = last; length < whole.size(); ++length) {
    scratch_.file("journal.csv", whole.substr(0, length));
    {
      Journal journal(path_, design_);
      EXPECT_THAT(journal.rows(), ElementsAre(Key(0), Key(4)));
      journal.add(row_of(2, 0.2));
    }
    EXPECT_EQ(contents(path_), whole);
  }
}

TEST_F(AJournal, KeepsWhatStandsBehindDamagedRowsAndCountsThese) {
  const std::string whole = contents(path_);
  const std::string unchecked = whole.substr(0, whole.find('\n') - 17) + "\n";
  for (const std::string& damage :
       {std::string("garbage\n"), std::string("99,0,1,fine\n"), std::string("-1,\n"),
        std::string("\n"), std::string(",\n"), std::string("1,0,fine,1\n"),
        std::string("9223372036854775807,0,fine,1\n"), std::string("\0\n", 2), unchecked}) {
    scratch_.file("journal.csv", whole + damage + damage + whole);
    const Journal journal(path_, design_);
    EXPECT_THAT(journal.rows(), ElementsAre(Key(0), Key(2), Key(4)));
    EXPECT_EQ(journal.damaged(), 2);
    EXPECT_EQ(contents(path_), whole + whole);
  }
}

TEST_F(AJournal, FindsEveryChangedBit) {
  const std::string whole = contents(path_);
  const auto rows = Journal(path_, design_).rows();
  for (std::size_t at = 0; at < whole.size() * 8; ++at) {
    std::string changed = whole;
    changed[at / 8] = static_cast<char>(changed[at / 8] ^ (1 << at % 8));
    scratch_.file("journal.csv", changed);
    const Journal journal(path_, design_);
    const bool last = at / 8 == whole.size() - 1;  // the end of the last row: cut off
    EXPECT_EQ(journal.damaged(), last ? 0 : 1) << at;
    EXPECT_GE(journal.rows().size(), 1u) << at;
    for (const auto& [run, row] : journal.rows())
      EXPECT_EQ(row_text(design_, row), row_text(design_, rows.at(run))) << at;
  }
}

TEST_F(AJournal, HasNoRowsOfOtherParameters) {
  Design other = design_;
  other.base.deformation = 0.25;  // the same runs by their seeds and varied parameters
  const Journal journal(path_, other);
  EXPECT_TRUE(journal.rows().empty());
  EXPECT_EQ(journal.damaged(), 3);
}

TEST_F(AJournal, IsARegularFile) {
  const std::string victim = scratch_.file("victim", "mine\n"), link = scratch_.path("link.csv");
  std::filesystem::create_symlink(victim, link);
  std::filesystem::create_symlink(scratch_.path("nowhere"), scratch_.path("dangling.csv"));
  ASSERT_EQ(::mkfifo(scratch_.path("pipe.csv").c_str(), 0600), 0);
  for (const char* name : {"link.csv", "dangling.csv", "pipe.csv"}) {
    EXPECT_THAT(
        pupflow::test::failure_of(io::ExitCode::bad_file,
                                  [&] { const Journal journal(scratch_.path(name), design_); }),
        ::testing::HasSubstr(name));
  }
  EXPECT_EQ(contents(victim), "mine\n");
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("nowhere")));
}

TEST_F(AJournal, SaysWhenItCannotBeWritten) {
  pupflow::test::failure_of(io::ExitCode::bad_file, [&] {
    const Journal journal(scratch_.path("no/such/folder/journal.csv"), design_);
  });
  pupflow::test::failure_of(io::ExitCode::bad_file,
                            [&] { const Journal journal(scratch_.folder().string(), design_); });
}

}  // namespace
}  // namespace pupflow::study
