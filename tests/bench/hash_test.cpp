// The benchmarks print what their litters came to: on any instruction set and any number of threads
// the same, so that none of them measures a faster wrong answer. Times are not looked at.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "bench/measure.h"
#include "bench/scenes.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  char part[4096];
  for (std::size_t got; (got = std::fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, got);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

/// What the benchmarks of one scene in one precision printed.
struct Printed {
  int benchmarks = 0;
  std::set<std::string> hashes;
};

/// By scene and precision, e.g. "huddling/float", after every benchmark has run as briefly as it
/// can.
std::map<std::string, Printed> printed_hashes() {
  const std::string text = output_of("'" PUPFLOW_BENCH
                                     "' --benchmark_filter='^step/(huddling|crowd)/' "
                                     "--benchmark_min_time=0.001 --benchmark_color=false 2>&1");
  std::map<std::string, Printed> printed;
  const std::regex line(R"(step/(\w+/\w+)/\S+ .*hash ([0-9a-f]{16}))");
  for (std::sregex_iterator match(text.begin(), text.end(), line), end; match != end; ++match) {
    Printed& scene = printed[(*match)[1]];
    ++scene.benchmarks;
    scene.hashes.insert((*match)[2]);
  }
  EXPECT_EQ(text.find("ERROR"), std::string::npos) << text;
  return printed;
}

TEST(BenchmarkHashes, AreTheSameForEveryInstructionSetAndNumberOfThreads) {
  auto printed = printed_hashes();
  const int sets = static_cast<int>(supported_instruction_sets().size());
  constexpr int kThreadCounts = 4;
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    const std::string in = std::string("/") + precision_name(precision);
    EXPECT_EQ(printed["huddling" + in].benchmarks, sets + kThreadCounts);
    EXPECT_EQ(printed["crowd" + in].benchmarks, kThreadCounts);
    EXPECT_EQ(printed["crowd" + in].hashes.size(), 1u);
    Simulation expected(settled(huddling(precision)).snapshot(), InstructionSet::baseline);
    ASSERT_TRUE(expected.run(20).ok());
    EXPECT_EQ(printed["huddling" + in].hashes, std::set{hash_text(expected.hash())});
  }
}

}  // namespace
}  // namespace pupflow::bench
