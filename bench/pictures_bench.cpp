// Draw lists, pictures and PNG files.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "app/io/failure.h"
#include "app/io/png.h"
#include "bench/benchmarks.h"
#include "bench/sitting.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

/// Runs `measure` with a sitting, or says why there is none.
template <class Measure>
void with_sitting(benchmark::State& state, Measure measure) {
  try {
    Sitting sitting;
    measure(sitting);
  } catch (const io::Failure& failure) {
    state.SkipWithError(failure.what());
  }
}

void list(benchmark::State& state) {
  const Simulation& litter = settled(huddling(Precision::float_));
  with_sitting(state, [&](Sitting& sitting) {
    for (auto _ : state) sitting.list(litter);
  });
}

void draw(benchmark::State& state, int pups, int supersample) {
  Params params = huddling(Precision::float_);
  params.pups = pups;
  with_sitting(state, [&](Sitting& sitting) {
    sitting.list(settled(params));
    for (auto _ : state) sitting.draw(supersample);
  });
}

void read(benchmark::State& state) {
  with_sitting(state, [&](Sitting& sitting) {
    for (auto _ : state) benchmark::DoNotOptimize(sitting.read());
  });
}

/// Smooth colors with a few edges, which a filter and deflate find much as they find a litter.
io::Image some_picture() {
  io::Image image(kPictureWidth, kPictureHeight);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int dx = x % 40 - 20, dy = y % 40 - 20;
      const int shade = dx * dx + dy * dy < 400 ? 400 - dx * dx - dy * dy : 0;
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = static_cast<std::uint8_t>(shade / 2);
      pixel[1] = static_cast<std::uint8_t>(shade / 4 + x / 16);
      pixel[2] = static_cast<std::uint8_t>(255 - shade / 2);
      pixel[3] = 255;
    }
  }
  return image;
}

void write(benchmark::State& state) {
  const io::Image image = some_picture();
  const std::string path = (std::filesystem::temp_directory_path() / "pupflow-bench.png").string();
  for (auto _ : state) io::write_png(path, image, {}, true);
  std::filesystem::remove(path);
}

}  // namespace

void register_pictures() {
  benchmark::RegisterBenchmark("picture/list", list)->Unit(benchmark::kMicrosecond);
  const auto add = [](const char* name, int pups, int supersample) {
    benchmark::RegisterBenchmark(name, draw, pups, supersample)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  };
  add("picture/draw_arena/1x1", 0, 1);
  add("picture/draw_litter/1x1", 12, 1);
  add("picture/draw_litter/2x2", 12, 2);
  benchmark::RegisterBenchmark("picture/read", read)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("picture/png", write)->Unit(benchmark::kMillisecond);
}

}  // namespace pupflow::bench
