// Pictures: drawing, reading back, encoding.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/io/png.h"
#include "bench/measure.h"
#include "bench/sections.h"
#include "bench/sitting.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

/// Whole frames, finding and drawing, of today and as version 0.1.0 drew them.
void whole_frames(int rounds, Verdicts& verdicts) {
  constexpr int kMany = 1000, kManySteps = 200;
  struct Case {
    Params params;
    std::int64_t steps;
    int width, height;
  };
  const Params twelve = huddling(Precision::float_);
  const Case cases[] = {
      {twelve, kLanded, kPictureWidth, kPictureHeight},
      {twelve, kLanded, kPictureWidth / 2, kPictureHeight / 2},
      {crowd(kMany, Precision::float_), kManySteps, kPictureWidth, kPictureHeight}};
  std::printf("\n| whole frame, ms of processor | today | as version 0.1.0 | through today |\n");
  std::printf("|---|---|---|---|\n");
  for (const Case& each : cases) {
    const Simulation& litter = settled(each.params, each.steps);
    Sitting sitting(each.params, each.width, each.height);
    const auto times = in_turns({{"today",
                                  [&] {
                                    return program_microseconds([&] {
                                      sitting.list(litter);
                                      sitting.draw(1);
                                    });
                                  }},
                                 {"as version 0.1.0",
                                  [&] {
                                    return program_microseconds([&] {
                                      sitting.list_points(litter);
                                      sitting.draw(2);
                                    });
                                  }}},
                                3 * rounds);
    char name[64];
    std::snprintf(name, sizeof name, "%d pups, %d × %d", each.params.pups, each.width, each.height);
    std::printf("| %s | %.1f | %.1f | %.2f |\n", name, 1e-3 * median(times[0]),
                1e-3 * median(times[1]), ratio(times[1], times[0]));
    verdicts.measured(std::string("a frame as version 0.1.0 drew it through one of today, ") + name,
                      ratio(times[1], times[0]));
  }
}

}  // namespace

void pictures(int rounds, Verdicts& verdicts) {
  setenv("LP_NUM_THREADS", "1", 0);  // software OpenGL: one core, as everything else here
  const Simulation& litter = settled(huddling(Precision::float_), kLanded);
  Params params = litter.params();
  params.pups = 0;
  const Simulation nobody(params);
  Sitting sitting;
  const std::string file = (std::filesystem::temp_directory_path() / "pupflow-bench.png").string();
  io::Image frame;
  const auto drawing = [&](const Simulation& scene, int supersample) {
    sitting.list(scene);
    return microseconds([&] { sitting.draw(supersample); });
  };
  const auto plain_drawing = [&](const Simulation& scene) {
    sitting.list_points(scene);
    return microseconds([&] { sitting.draw_plainly(); });
  };
  const std::vector<Contender> contenders = {
      {"baseline: clearing and a plain floor", [&] { return plain_drawing(nobody); }},
      {"baseline: the litter on it", [&] { return plain_drawing(litter); }},
      {"drawing the arena alone", [&] { return drawing(nobody, 1); }},
      {"drawing the litter", [&] { return drawing(litter, 1); }},
      {"drawing the arena alone, 2 × 2 samples a pixel", [&] { return drawing(nobody, 2); }},
      {"drawing the litter, 2 × 2 samples", [&] { return drawing(litter, 2); }},
      {"finding what is visible", [&] { return microseconds([&] { sitting.list(litter); }); }},
      {"reading the picture back", [&] { return microseconds([&] { frame = sitting.read(); }); }},
      {"writing it as PNG",
       [&] { return microseconds([&] { io::write_png(file, frame, {}, true); }); }}};
  const auto times = in_turns(contenders, 3 * rounds);
  std::printf("| picture of %d × %d | ms |\n|---|---|\n", kPictureWidth, kPictureHeight);
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::printf("| %s | %.2f |\n", contenders[i].name.c_str(), 1e-3 * median(times[i]));
  }
  std::filesystem::remove(file);
  verdicts.measured("drawing the litter through the baseline's drawing", ratio(times[3], times[1]));
  whole_frames(rounds, verdicts);
}

}  // namespace pupflow::bench
