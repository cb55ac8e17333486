// pupflow_bench_ratios: what docs/performance.md reports, measured in one run. Its exit status says
// nothing about times, since they are no test.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "app/io/failure.h"
#include "app/io/machine.h"
#include "bench/sections.h"

namespace pupflow::bench {
namespace {

struct Section {
  std::string name;
  void (*measure)(int rounds, Verdicts& verdicts);
};

// Memory is measured in children that begin as big as their parent: recording and scaling go first.
const std::vector<Section> kSections = {
    {"recording", recording}, {"scaling", scaling},     {"whole", whole_steps},
    {"stages", stages},       {"rules", contact_rules}, {"floors", step_floors},
    {"threads", threads},     {"start", start_up},      {"pictures", pictures}};

struct Options {
  int rounds = 11;
  std::vector<Section> sections;
};

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (const std::string& argument : arguments) {
    if (argument.starts_with("--rounds=")) {
      options.rounds = std::atoi(argument.c_str() + std::string("--rounds=").size());
      if (options.rounds < 1) throw std::invalid_argument("--rounds is a number from 1 upwards");
      continue;
    }
    bool known = false;
    for (const Section& section : kSections) {
      if (section.name != argument) continue;
      options.sections.push_back(section);
      known = true;
    }
    if (!known) throw std::invalid_argument("there is no section '" + argument + "'");
  }
  if (options.sections.empty()) options.sections = kSections;
  return options;
}

void print_machine() {
  double load = 0;  // of the last minute
  getloadavg(&load, 1);
  std::printf("| processor | cores | busy before | compiler | loops compiled for |\n");
  std::printf("|---|---|---|---|---|\n| %s | %u | %.1f | %s | %s |\n", io::cpu_name().c_str(),
              std::thread::hardware_concurrency(), load, io::compiler_words().c_str(),
              io::kernel_words().c_str());
}

void run(const Options& options) {
  std::printf("<!-- measured machine -->\n");
  print_machine();
  Verdicts verdicts;
  for (const Section& section : options.sections) {
    std::printf("\n<!-- measured %s -->\n", section.name.c_str());
    std::fflush(stdout);
    section.measure(options.rounds, verdicts);
  }
  const bool all = options.sections.size() == kSections.size();
  std::printf("\n<!-- measured %s -->\n", all ? "verdicts" : "some verdicts");
  verdicts.print();
}

}  // namespace
}  // namespace pupflow::bench

int main(int argc, char** argv) {
  using namespace pupflow::bench;
  try {
    run(parse({argv + 1, argv + argc}));
  } catch (const std::invalid_argument& problem) {
    std::fprintf(stderr, "pupflow_bench_ratios: %s\n", problem.what());
    std::fprintf(stderr, "usage: pupflow_bench_ratios [--rounds=N] [SECTION...]; sections:");
    for (const Section& section : kSections) std::fprintf(stderr, " %s", section.name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "pupflow_bench_ratios: %s\n", problem.what());
    return 1;
  }
}
