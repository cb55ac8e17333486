// A run is its recipe: changes on the way, outputs that repeat it, and 'pupflow verify'.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "hdf5_edit.h"
#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CliRecipe : public testing::Test {
 protected:
  test::Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }
  /// A small run with a change, a ramp and a pushed pup; quiet, and expected to work.
  void run(std::vector<std::string> more) const {
    const std::vector<std::string> small{"run",
                                         "--set",
                                         "pups=3",
                                         "--set",
                                         "face_points=3",
                                         "--at",
                                         "step=20,ta=0.2",
                                         "--at",
                                         "step=30,until=50,ta=0.8",
                                         "--at",
                                         "step=35,until=45,pup=1,force=[2,0,0]",
                                         "--quiet"};
    more.insert(more.begin(), small.begin(), small.end());
    const test::Outcome outcome = pupflow(more);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  std::string contents(const std::string& name) const {
    return test::contents(scratch_.path(name));
  }

  /// Writes NAME with the first `from` in it replaced, and returns NAME.
  std::string spoilt(const std::string& of, const std::string& name, const std::string& from,
                     const std::string& to) const {
    std::string text = contents(of);
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    scratch_.file(name, text.replace(place, from.size(), to));
    return name;
  }
  test::Scratch scratch_;
};

/// The rows of a CSV file, without its comments.
std::string rows(const std::string& text) {
  std::string rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) rows += line + '\n';
  }
  return rows;
}

TEST_F(CliRecipe, OutputsRepeatTheRun) {
  run({"--steps", "60", "--csv", "m.csv", "--pups", "p.csv", "--checkpoint", "c.h5", "--record",
       "r.h5", "--record-every", "7", "--record-from", "0", "--record-fields",
       "pup,afferent,point"});
  const std::string changes =
      "# at = step=20,ta=0.2; step=30,until=50,ta=0.8; step=35,until=45,pup=1,force=[2,0,0]\n";
  EXPECT_THAT(contents("m.csv"), AllOf(HasSubstr(changes), HasSubstr("\n# step = 60\n# hash = ")));
  for (const char* file : {"m.csv", "p.csv", "c.h5", "r.h5"}) {
    const std::string again = std::string("of-") + file + ".csv";
    ASSERT_EQ(pupflow({"run", "--like", file, "--csv", again, "--quiet"}).code, 0);
    EXPECT_EQ(contents(again), contents("m.csv")) << file;
  }
  const test::Outcome verdict = pupflow({"verify", "m.csv", "p.csv", "c.h5", "r.h5"});
  EXPECT_EQ(verdict.code, 0) << verdict.err;
  EXPECT_THAT(verdict.out, AllOf(HasSubstr("m.csv: same (60 steps, 60 rows)\n"),
                                 HasSubstr("p.csv: same (60 steps, 180 rows)\n"),
                                 HasSubstr("c.h5: same (step 60, hash "),
                                 HasSubstr("r.h5: same (56 steps, 9 frames of ")));
}

TEST_F(CliRecipe, ARunThatGoesOnCarriesWhatWasBefore) {
  run({"--steps", "40", "--checkpoint", "c.h5"});
  const std::vector<std::string> on{"run",     "--from", "c.h5",      "--steps", "60",
                                    "--quiet", "--set",  "alpha=0.5", "--at",    "step=50,drive=2"};
  std::vector<std::string> with_csv = on;
  with_csv.insert(with_csv.end(), {"--csv", "on.csv", "--pups", "on-pups.csv"});
  ASSERT_EQ(pupflow(with_csv).code, 0);
  EXPECT_THAT(contents("on.csv"), AllOf(HasSubstr("step=40,alpha=0.5; step=50,drive=2\n"),
                                        HasSubstr("# begun = 40\n")));
  ASSERT_EQ(pupflow({"run", "--like", "on.csv", "--csv", "all.csv", "--quiet"}).code, 0);
  EXPECT_THAT(
      rows(contents("all.csv")),
      testing::EndsWith(rows(contents("on.csv")).substr(rows(contents("on.csv")).find('\n') + 1)));
  const test::Outcome verdict = pupflow({"verify", "on.csv", "on-pups.csv"});
  EXPECT_EQ(verdict.code, 0) << verdict.out;
}

TEST_F(CliRecipe, VerifyNamesTheFirstDifference) {
  run({"--steps", "60", "--csv", "m.csv", "--pups", "p.csv", "--every", "5"});
  spoilt("m.csv", "row.csv", "\n25,", "\n25,9");
  EXPECT_THAT(pupflow({"verify", "row.csv"}).out,
              HasSubstr("row.csv: differs (step 25: time is 9"));
  spoilt("p.csv", "pup.csv", "\n30,2,", "\n30,2,7");
  const test::Outcome pup = pupflow({"verify", "pup.csv", "m.csv"});
  EXPECT_EQ(pup.code, 1);
  EXPECT_THAT(pup.out, AllOf(HasSubstr("pup.csv: differs (step 30, pup 2: x is 7"),
                             HasSubstr("m.csv: same")));
  EXPECT_THAT(pup.err, HasSubstr("1 of 2 files differ"));
  spoilt("m.csv", "seed.csv", "# seed = 1\n", "# seed = 2\n");
  EXPECT_EQ(pupflow({"verify", "seed.csv", "--quiet"}).code, 1);
  spoilt("m.csv", "change.csv", "step=20,ta=0.2", "step=21,ta=0.2");
  EXPECT_THAT(pupflow({"verify", "change.csv"}).out, HasSubstr("differs (step 25: mean_tb is"));
}

TEST_F(CliRecipe, VerifyMissesWhatIsNotThere) {
  run({"--steps", "60", "--csv", "m.csv", "--pups", "p.csv", "--every", "5"});
  const auto said = [this](const std::string& file) {
    const test::Outcome verdict = pupflow({"verify", file});
    EXPECT_EQ(verdict.code, 1) << verdict.out;
    return verdict.out;
  };
  /// Without what stands between the two texts, the former included.
  const auto without = [&](const char* file, const std::string& from, const std::string& to) {
    std::string text = contents(file);
    const std::size_t begin = text.find(from) + 1, end = text.find(to, begin) + 1;
    text.erase(begin, to.empty() ? std::string::npos : end - begin);
    scratch_.file("cut.csv", text);
    return said("cut.csv");
  };
  EXPECT_THAT(without("m.csv", "\n25,", "\n30,"), HasSubstr("rows between step 20 and step 30"));
  EXPECT_THAT(without("m.csv", "\n5,", "\n10,"), HasSubstr("are missing"));
  EXPECT_THAT(without("m.csv", "\n55,", "\n# step"), HasSubstr("rows after step 50 are missing"));
  EXPECT_THAT(without("m.csv", "\n# step = 60", ""), HasSubstr("the file ends after step 60"));
  EXPECT_THAT(without("m.csv", "\n50,", ""), HasSubstr("the file ends after step 45"));
  EXPECT_THAT(without("p.csv", "\n25,1,", "\n25,2,"), HasSubstr("before step 25, pup 2"));
  EXPECT_THAT(without("p.csv", "\n25,0,", "\n30,0,"),
              HasSubstr("rows between step 20 and step 30"));
  EXPECT_THAT(without("p.csv", "\n60,2,", "\n# step"), HasSubstr("rows of step 60 are missing"));
  spoilt("m.csv", "hash.csv", "# hash = ", "# hash = 0");
  EXPECT_THAT(said("hash.csv"), HasSubstr("the hash of the state is 0"));
  spoilt("p.csv", "twice.csv", "\n25,2,", "\n25,1,");
  EXPECT_THAT(said("twice.csv"), HasSubstr("before step 25, pup 1"));
}

TEST_F(CliRecipe, ARecordingThatBeginsWithACheckpointIsVerified) {
  run({"--steps", "20", "--checkpoint", "c.h5"});
  ASSERT_EQ(
      pupflow({"run", "--from", "c.h5", "--steps", "30", "--record", "r.h5", "--record-every", "1",
               "--record-from", "20", "--record-fields", "pup,afferent,point", "--quiet"})
          .code,
      0);
  const test::Outcome verdict = pupflow({"verify", "r.h5"});
  EXPECT_EQ(verdict.code, 0) << verdict.out;
  EXPECT_THAT(verdict.out, HasSubstr("11 frames"));
}

TEST_F(CliRecipe, VerifySaysWhyAWindowsCsvCannotBeRepeated) {
  run({"--steps", "20", "--csv", "m.csv"});
  spoilt("m.csv", "live.csv", "# seed = 1\n", "# seed = 1\n# command = live\n");
  const test::Outcome verdict = pupflow({"verify", "live.csv"});
  EXPECT_EQ(verdict.code, 2);
  EXPECT_THAT(verdict.err, HasSubstr("plots of the live window"));
}

/// Sets one number of a two-dimensional data set.
void set_number(hid_t file, const char* name, hsize_t row, hsize_t column, double value) {
  const io::Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  const io::Handle space(H5Dget_space(set), H5Sclose);
  const hsize_t place[2] = {row, column}, one[2] = {1, 1};
  H5Sselect_hyperslab(space, H5S_SELECT_SET, place, nullptr, one, nullptr);
  const io::Handle single(H5Screate_simple(2, one, nullptr), H5Sclose);
  EXPECT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, single, space, H5P_DEFAULT, &value), 0);
}

TEST_F(CliRecipe, VerifyNamesTheFirstDifferenceOfARecording) {
  run({"--steps", "60", "--record", "r.h5", "--record-every", "4"});
  test::edit_hdf5(scratch_.path("r.h5"), "recording",
                  [](hid_t file) { set_number(file, "pup/exposed", 9, 2, 0.125); });
  const test::Outcome verdict = pupflow({"verify", "r.h5"});
  EXPECT_EQ(verdict.code, 1);
  EXPECT_THAT(verdict.out,
              HasSubstr("r.h5: differs (step 40, pup 2: exposed is 0.125 in the file"));
}

TEST_F(CliRecipe, SweepsAreVerifiedRunByRun) {
  ASSERT_EQ(pupflow({"sweep", "--set", "pups=2", "--set", "face_points=2", "--set", "steps=30",
                     "--set", "discard=10", "--vary", "ta=0.2,0.8", "--seeds", "2", "--at",
                     "step=15,ta=0.5", "--out", "s", "--quiet"})
                .code,
            0);
  const test::Outcome verdict = pupflow({"verify", "s"});
  EXPECT_EQ(verdict.code, 0) << verdict.err << verdict.out;
  EXPECT_THAT(verdict.out, HasSubstr("s: same (4 runs)"));
  std::string text = contents("s/runs.csv");
  text.replace(text.rfind(','), 1, ",9");
  scratch_.file("bad.csv", text);
  EXPECT_THAT(pupflow({"verify", "bad.csv"}).out,
              HasSubstr("bad.csv: differs (row 4: exposed_sd is 9"));
  EXPECT_EQ(pupflow({"verify", "bad.csv", "--row", "3"}).code, 0);
  EXPECT_EQ(pupflow({"verify", "bad.csv", "--row", "5"}).code, 2);
  scratch_.file("cut.csv", text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  EXPECT_THAT(pupflow({"verify", "cut.csv"}).out, HasSubstr("has 3 runs, its sweep 4"));
  // One of its runs, by itself.
  ASSERT_EQ(
      pupflow({"run", "--like", "s/runs.csv", "--row", "3", "--csv", "three.csv", "--quiet"}).code,
      0);
  EXPECT_THAT(contents("three.csv"),
              AllOf(HasSubstr("# ta = 0.8\n"), HasSubstr("# at = step=15,ta=0.5\n"),
                    Not(HasSubstr("# seed = 1\n"))));
  EXPECT_EQ(pupflow({"run", "--row", "3"}).code, 2);
}

TEST_F(CliRecipe, WhatCannotBeRepeatedIsRefused) {
  scratch_.file("other.csv", "# Software = pupflow 0.2.0\na,b\n1,2\n");
  scratch_.file("foreign.csv", "step,time\n1,2\n");
  run({"--steps", "20", "--csv", "m.csv"});
  spoilt("m.csv", "edited.csv", "# seed = 1\n", "# seed = 1\n# edited = 5\n");
  for (const char* file : {"other.csv", "foreign.csv", "missing.csv", "edited.csv"}) {
    const test::Outcome outcome = pupflow({"verify", file});
    EXPECT_THAT(outcome.code, testing::AnyOf(2, 4)) << file;
    EXPECT_THAT(outcome.err, HasSubstr(file));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_THAT(pupflow({"verify", "edited.csv"}).err,
              HasSubstr("pups were set by hand after step 5"));
}

TEST_F(CliRecipe, ChangesAndCheckpointsThatDoNotFitAreRefused) {
  run({"--steps", "40", "--checkpoint", "c.h5"});
  const test::Outcome past = pupflow({"run", "--from", "c.h5", "--at", "step=30,ta=0.1"});
  EXPECT_EQ(past.code, 2);
  EXPECT_THAT(past.err, HasSubstr("c.h5 is at step 40; a change must begin there or later"));
  const test::Outcome beyond = pupflow({"run", "--from", "c.h5", "--steps", "30"});
  EXPECT_EQ(beyond.code, 2);
  EXPECT_THAT(beyond.err, HasSubstr("is at step 40, and the run ends at step 30"));
  for (const char* verb : {"run", "render", "explain", "figure1"}) {
    const test::Outcome wrong = pupflow({verb, "--at", "step=5,tta=1"});
    EXPECT_EQ(wrong.code, 2) << verb;
    EXPECT_THAT(wrong.err, HasSubstr("did you mean 'ta'?")) << verb;
  }
}

}  // namespace
}  // namespace pupflow
