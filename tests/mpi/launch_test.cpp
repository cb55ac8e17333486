// The program with a launcher's environment variables and without the MPI module.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Words = std::vector<std::string>;

class Launch : public testing::Test {
 protected:
  Launch() { std::filesystem::copy_file(PUPFLOW_PROGRAM, scratch_.path("pupflow")); }

  /// Runs the copy, which has no module beside it, with `variables` in its environment.
  Outcome pupflow(const Words& variables, const Words& words) const {
    Words all = variables;
    all.push_back(scratch_.path("pupflow"));
    all.insert(all.end(), words.begin(), words.end());
    return test::run_program("/usr/bin/env", all, scratch_.folder().string());
  }

  const Words sweep_{"sweep", "--vary", "ta=0,1", "--seeds", "1",         "--steps",
                     "2",     "--set",  "pups=1", "--set",   "discard=0", "--quiet"};
  const test::Scratch scratch_;
};

TEST_F(Launch, WithoutTheModuleRanksAreRefusedAndOnlyRankZeroSaysSo) {
  const std::vector<std::pair<std::string, std::string>> launchers{
      {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
      {"PMI_RANK", "PMI_SIZE"},
      {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};
  for (const auto& [rank, size] : launchers) {
    const Outcome first = pupflow({rank + "=0", size + "=4"}, sweep_);
    EXPECT_EQ(first.code, 2);
    EXPECT_THAT(first.err, StartsWith("pupflow: started as one of 4 ranks, but this pupflow was "
                                      "built without MPI"));
    EXPECT_THAT(first.err, HasSubstr("--shard"));
    const Outcome other = pupflow({rank + "=1", size + "=4"}, sweep_);
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.err, IsEmpty());
  }
  EXPECT_EQ(scratch_.entries(), 1);
}

TEST_F(Launch, AModuleThatDoesNotLoadIsReportedWithTheReason) {
  scratch_.file("libpupflow_mpi.so", std::string(4096, '?'));
  EXPECT_THAT(pupflow({"PMI_RANK=0", "PMI_SIZE=4"}, sweep_).err, HasSubstr("invalid ELF header"));
}

TEST_F(Launch, OneProcessOrAJobStepWithoutMpiComputesAlone) {
  EXPECT_EQ(pupflow({"OMPI_COMM_WORLD_RANK=0", "OMPI_COMM_WORLD_SIZE=1"}, sweep_).code, 0);
  EXPECT_EQ(pupflow({"SLURM_PROCID=0", "SLURM_STEP_NUM_TASKS=4"}, sweep_).code, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch_.path("sweep/summary.csv")));
}

TEST_F(Launch, OtherVerbsIgnoreTheLauncher) {
  const Outcome outcome = pupflow({"PMI_RANK=1", "PMI_SIZE=4"}, {"params", "--nonsense"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--nonsense"));
  EXPECT_EQ(pupflow({"PMI_RANK=1", "PMI_SIZE=4"}, {"params"}).code, 0);
}

TEST_F(Launch, LostAfterMustBeAWholeNumberOfSeconds) {
  for (const char* text : {"", "0", "-3", "1.5", "soon"}) {
    const Outcome outcome =
        pupflow({"PMI_RANK=0", "PMI_SIZE=4", std::string("PUPFLOW_LOST_AFTER=") + text}, sweep_);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, StartsWith("pupflow: PUPFLOW_LOST_AFTER: "));
    EXPECT_THAT(outcome.err, HasSubstr("not '" + std::string(text) + "'\n"));
  }
}

}  // namespace
}  // namespace pupflow
