#include "app/study/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST_F(AJournal, DropsFromTheFirstDamagedLineOn) {
  const std::string whole = contents(path_);
  for (const std::string damage :
       {"garbage\n", "99,0,1,fine\n", "-1,\n", "\n", ",\n", "1,0,fine,1\n"}) {
    scratch_.file("journal.csv", whole + damage + whole);
    EXPECT_THAT(Journal(path_, design_).rows(), ElementsAre(Key(0), Key(2), Key(4)));
    EXPECT_EQ(contents(path_), whole);
  }
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
