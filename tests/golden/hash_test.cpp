// One seed, one hash: for every compiler, build type and instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "pupflow/simulation.h"
#include "tests/golden/golden_runs.h"

namespace pupflow {
namespace {

class Golden : public testing::TestWithParam<GoldenRun> {};

TEST_P(Golden, HasItsHashWithEveryInstructionSet) {
  for (const InstructionSet set : supported_instruction_sets()) {
    Simulation simulation(params_of(GetParam()), set);
    EXPECT_TRUE(simulation.run(kGoldenSteps).ok());
    EXPECT_EQ(simulation.hash(), GetParam().hash) << instruction_set_name(set);
  }
}

std::string name_of(const testing::TestParamInfo<GoldenRun>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(kGoldenRuns), name_of);

}  // namespace
}  // namespace pupflow
