#include "app/study/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/failing.h"
#include "tests/study/small_design.h"
#include "tests/support/scratch.h"

namespace pupflow::study {
namespace {

using io::ExitCode;
using pupflow::test::contents;
using pupflow::test::failure_of;
using pupflow::test::Scratch;
using ::testing::AllOf;
using ::testing::HasSubstr;

class AFolder : public ::testing::Test {
 protected:
  std::string refused(ExitCode code, const Design& design) {
    return failure_of(code, [&] { claim_folder(folder_, design, false); });
  }
  const Scratch scratch_;
  const std::string folder_ = scratch_.path("deep/sweep");
  const Design design_ = test::small_design({"ta=0,1"}, 2),
               other_ = test::small_design({"ta=0,1"}, 3);
};

TEST_F(AFolder, IsMadeAndHoldsItsDesign) {
  claim_folder(folder_, design_, false);
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(design_));
  EXPECT_EQ(manifest_text(design_of_folder(folder_)), manifest_text(design_));
}

TEST_F(AFolder, KeepsItsResultsWhenTheSameSweepGoesOn) {
  claim_folder(folder_, design_, false);
  scratch_.file("deep/sweep/journal.csv", "rows");
  claim_folder(folder_, design_, false);
  claim_folder(folder_, design_, true);
  EXPECT_EQ(contents(journal_path(folder_)), "rows");
}

TEST_F(AFolder, RefusesAnotherSweepAndNamesTheDifference) {
  claim_folder(folder_, design_, false);
  EXPECT_THAT(refused(ExitCode::bad_input, other_),
              AllOf(HasSubstr("'seeds = 2' there, 'seeds = 3' now"), HasSubstr("--force")));
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(design_));
}

TEST_F(AFolder, StartsAfreshWhenForced) {
  claim_folder(folder_, design_, false);
  for (const char* name : {"journal.csv", "runs.csv", "summary.csv", "sweep.png", "sweep.gp"}) {
    scratch_.file(std::string("deep/sweep/") + name, "old");
  }
  scratch_.file("deep/sweep/notes.txt", "mine");
  claim_folder(folder_, other_, true);
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(other_));
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);  // manifest and notes
}

TEST_F(AFolder, RefusesFilesThatNoManifestExplains) {
  for (const char* name :
       {"journal.csv", "runs.csv", "summary.csv", "sweep.png", "sweep.svg", "sweep.gp"}) {
    const Scratch scratch;
    scratch.file(name, "somebody's");
    EXPECT_THAT(failure_of(ExitCode::bad_file,
                           [&] { claim_folder(scratch.folder().string(), design_, false); }),
                AllOf(HasSubstr(name), HasSubstr("--force")));
    EXPECT_EQ(contents(scratch.path(name)), "somebody's");
  }
}

TEST_F(AFolder, ThatCannotBeMadeIsAnErrorOfFiles) {
  scratch_.file("deep", "a file");
  EXPECT_THAT(refused(ExitCode::bad_file, design_), HasSubstr("cannot make this folder"));
}

TEST_F(AFolder, OfAnotherVersionIsNotRead) {
  claim_folder(folder_, design_, false);
  std::string text = manifest_text(design_);
  const std::size_t at = text.find("software = \"pupflow ");
  ASSERT_NE(at, std::string::npos);
  text.insert(at + 20, "9");
  scratch_.file("deep/sweep/manifest.toml", text);
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { design_of_folder(folder_); }),
              HasSubstr("software"));
}

}  // namespace
}  // namespace pupflow::study
