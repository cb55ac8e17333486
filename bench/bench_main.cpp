// pupflow_bench: every part by itself, with Google Benchmark. --help lists its options.
#include <benchmark/benchmark.h>

#include "app/io/machine.h"
#include "bench/benchmarks.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("processor", pupflow::io::cpu_name());
  benchmark::AddCustomContext("compiler", pupflow::io::compiler_words());
  benchmark::AddCustomContext("loops compiled for", pupflow::io::kernel_words());
  pupflow::bench::register_steps();
  pupflow::bench::register_stages();
  pupflow::bench::register_litters();
  pupflow::bench::register_pictures();
  benchmark::RunSpecifiedBenchmarks();
}
