#include "app/study/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study/files.h"
#include "app/study/journal.h"
#include "app/study/lock.h"
#include "app/study/plot_script.h"
#include "app/study/series.h"
#include "app/study/table.h"
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
  const Design design_ = test::small_design({"ta=0,1"}, 3),
               other_ = test::small_design({"ta=0,1"}, 2);
};

TEST_F(AFolder, IsMadeAndHoldsItsDesign) {
  claim_folder(folder_, design_, false);
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(design_));
  EXPECT_EQ(manifest_text(design_of_folder(folder_)), manifest_text(design_));
}

TEST_F(AFolder, KeepsItsResultsWhenTheSameSweepGoesOnUnlessForced) {
  claim_folder(folder_, design_, false);
  scratch_.file("deep/sweep/journal.csv", "rows");
  claim_folder(folder_, design_, false);
  EXPECT_EQ(contents(journal_path(folder_)), "rows");
  claim_folder(folder_, design_, true);
  EXPECT_FALSE(std::filesystem::exists(journal_path(folder_)));
}

TEST_F(AFolder, RefusesAnotherSweepAndNamesTheDifference) {
  claim_folder(folder_, design_, false);
  EXPECT_THAT(refused(ExitCode::bad_input, other_),
              AllOf(HasSubstr("'seeds = 3' there, 'seeds = 2' now"), HasSubstr("--force")));
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(design_));
}

TEST_F(AFolder, ShowsOfLongLinesWhatDiffers) {
  const std::string line = "vary = [\"ta=" + std::string(5'000, '1');
  const std::string text = manifest_difference(line + "2" + line, line + "3" + line);
  EXPECT_THAT(text, AllOf(HasSubstr("112vary"), HasSubstr("113vary")));
  EXPECT_LT(text.size(), 300u);
  EXPECT_EQ(manifest_difference("a", "a\nb\n"), "'' there, 'b' now");
  EXPECT_EQ(manifest_difference("a\n", "a\n"), "nothing");
}

TEST_F(AFolder, StartsAfreshWhenForced) {
  claim_folder(folder_, design_, false);
  for (const char* name : {"journal.csv", "runs.csv", "summary.csv", "sweep.png", "sweep.gp",
                           "figure2.gp", "figure2.png", "figure2.svg"}) {
    scratch_.file(std::string("deep/sweep/") + name, "old");
  }
  scratch_.file("deep/sweep/notes.txt", "mine");
  std::filesystem::create_directory(series_folder(folder_));
  scratch_.file("deep/sweep/series/1-12.csv", "old");
  claim_folder(folder_, other_, true);
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(other_));
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);  // manifest and notes
}

TEST_F(AFolder, LeavesWhatIsNoSeriesAmongTheSeries) {
  claim_folder(folder_, design_, false);
  std::filesystem::create_directory(series_folder(folder_));
  for (const char* name : {"1-1.csv", "mine.csv", "1-1.txt", "1-.csv", "-1-1.csv"})
    scratch_.file(std::string("deep/sweep/series/") + name, "");
  claim_folder(folder_, other_, true);
  const std::filesystem::directory_iterator files(series_folder(folder_));
  EXPECT_EQ(std::distance(begin(files), end(files)), 4);
}

class AnExtendedFolder : public AFolder {
 protected:
  /// A finished sweep, with the script of its figure.
  void SetUp() override {
    claim_folder(folder_, before_, false);
    write_runs(runs_path(folder_), before_, rows_);
    scratch_.file("deep/sweep/sweep.gp", plot_script(before_, summarise(before_, rows_)));
    scratch_.file("deep/sweep/sweep.png", "");
  }
  const Design before_ = test::small_design({"ta=0,1"}, 2),
               after_ = test::small_design({"ta=0,1"}, 12);
  const std::vector<Row> rows_{test::row_of(0, 1), test::row_of(1, 2), test::row_of(2, 3),
                               test::row_of(3, 4)};
};

TEST_F(AnExtendedFolder, KeepsItsRunsAndNothingThatWillChange) {
  claim_folder(folder_, after_, false);
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(after_));
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);  // manifest and journal
  const Journal journal(journal_path(folder_), after_);
  EXPECT_EQ(journal.rows().size(), 4u);
  EXPECT_EQ(journal.rows().at(13).means.mean_tb, 4);
}

TEST_F(AnExtendedFolder, KeepsAScriptThatWasEdited) {
  scratch_.file("deep/sweep/sweep.gp", "edited");
  claim_folder(folder_, after_, false);
  EXPECT_EQ(contents(folder_ + "/sweep.gp"), "edited");
}

TEST_F(AnExtendedFolder, MayGetSeriesAndLosesNone) {
  Design recorded = before_;
  recorded.record_every = 5;
  claim_folder(folder_, recorded, false);
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(recorded));
  EXPECT_THAT(refused(ExitCode::bad_input, before_), HasSubstr("'record_every = 5' there"));
  recorded.record_every = 6;
  EXPECT_THAT(refused(ExitCode::bad_input, recorded), HasSubstr("'record_every = 5' there"));
}

TEST_F(AnExtendedFolder, IsOneOfTheSameSweepAndWhole) {
  Design other = after_;
  other.base.deformation = 0.25;
  EXPECT_THAT(refused(ExitCode::bad_input, other), HasSubstr("holds another sweep"));
  other = after_;
  other.shard = {1, 2};
  EXPECT_THAT(refused(ExitCode::bad_input, other), HasSubstr("holds another sweep"));
  EXPECT_EQ(contents(manifest_path(folder_)), manifest_text(before_));
}

TEST_F(AFolder, KeepsTheTableOfItsDesign) {
  Design design = test::small_design({}, 2);
  parse_table("ta\n0.5\n0.25\n", "here", design);
  claim_folder(folder_, design, false);
  EXPECT_EQ(contents(table_path(folder_)), "ta\n0.5\n0.25\n");
  EXPECT_EQ(manifest_text(design_of_folder(folder_)), manifest_text(design));
  Design other = design;
  parse_table("ta\n0.5\n0.75\n", "here", other);
  EXPECT_THAT(refused(ExitCode::bad_input, other), HasSubstr("'table = "));
}

TEST_F(AFolder, TakesNoTableAndNoSeriesForItsOwnWithoutAManifest) {
  const Scratch scratch;
  const std::string folder = scratch.folder().string();
  scratch.file("design.csv", "somebody's");
  std::filesystem::create_directory(series_folder(folder));
  scratch.file("series/1-1.csv", "somebody's");
  Design table = test::small_design({}, 2), recorded = design_;
  parse_table("ta\n0.5\n", "here", table);
  recorded.record_every = 1;
  for (const Design& design : {table, recorded})
    failure_of(ExitCode::bad_file, [&] { claim_folder(folder, design, false); });
  claim_folder(folder, design_, true);
  EXPECT_EQ(contents(scratch.path("design.csv")), "somebody's");
  EXPECT_EQ(contents(scratch.path("series/1-1.csv")), "somebody's");
  claim_folder(folder, table, true);
  EXPECT_EQ(contents(scratch.path("design.csv")), "ta\n0.5\n");
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

TEST_F(AFolder, HoldsNoLinkThatASweepWritesThrough) {
  Design recorded = design_;
  recorded.record_every = 1;
  const std::string victim = scratch_.file("victim", "mine");
  std::filesystem::create_directory(scratch_.path("elsewhere"));
  for (const std::string name : {"manifest.toml", "journal.csv", "runs.csv", "summary.csv",
                                 "design.csv", "sweep.png", "sweep.svg", "sweep.gp", "series"}) {
    const Scratch scratch;
    const std::string folder = scratch.folder().string();
    std::filesystem::create_symlink(name == "series" ? scratch_.path("elsewhere") : victim,
                                    scratch.path(name));
    for (const bool force : {false, true}) {
      EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { claim_folder(folder, recorded, force); }),
                  AllOf(HasSubstr(name), HasSubstr("symbolic link")));
    }
  }
  EXPECT_EQ(contents(victim), "mine");
}

TEST_F(AFolder, SeriesAreNotWrittenThroughLinks) {
  Design recorded = design_;
  recorded.record_every = 1;
  claim_folder(folder_, recorded, false);
  std::filesystem::create_directory(series_folder(folder_));
  const std::string victim = scratch_.file("victim", "mine");
  std::filesystem::create_symlink(victim, series_path(folder_, recorded, 0));
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { write_series(folder_, recorded, 0, {}); }),
              HasSubstr("1-1.csv"));
  EXPECT_EQ(contents(victim), "mine");
}

TEST_F(AFolder, LosesWhatKilledProcessesLeft) {
  claim_folder(folder_, design_, false);
  std::filesystem::create_directories(folder_ + "/.pupflow-2147483647-0.plot/.cache");
  const std::string own = ".pupflow-" + std::to_string(::getpid()) + "-0.plot";
  for (const std::string& name :
       {std::string("runs.csv.4711.unfinished"), std::string("sweep.png.4711-1.unfinished"), own,
        std::string(".pupflow-x-0.plot"), std::string("mine.csv.4711.unfinished")})
    scratch_.file("deep/sweep/" + name, "");
  Design recorded = design_;
  recorded.record_every = 1;
  std::filesystem::create_directory(series_folder(folder_));
  scratch_.file("deep/sweep/series/1-1.csv.4711.unfinished", "");
  remove_leftovers(folder_, recorded);
  EXPECT_TRUE(std::filesystem::is_empty(series_folder(folder_)));
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename());
  EXPECT_THAT(names,
              ::testing::UnorderedElementsAre("manifest.toml", "series", own, ".pupflow-x-0.plot",
                                              "mine.csv.4711.unfinished"));
}

TEST_F(AFolder, IsHeldByOneProcessAtATime) {
  {
    const FolderLock first(folder_);
    EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { const FolderLock second(folder_); }),
                HasSubstr(folder_ + ": another process"));
  }
  EXPECT_FALSE(std::filesystem::exists(lock_path(folder_)));
  scratch_.file("deep/sweep/sweep.lock", "");  // of a process that was killed
  { const FolderLock again(folder_); }
  std::filesystem::create_symlink(scratch_.path("nowhere"), lock_path(folder_));
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { const FolderLock third(folder_); }),
              HasSubstr("sweep.lock: is a symbolic link"));
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
