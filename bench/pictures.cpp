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
  const auto whole_frame = [&] {
    return microseconds([&] {
      sitting.list(litter);
      sitting.draw(1);
    });
  };
  const auto earlier_frame = [&] {
    return microseconds([&] {
      sitting.list_points(litter);
      sitting.draw(2);
    });
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
       [&] { return microseconds([&] { io::write_png(file, frame, {}, true); }); }},
      {"a whole frame: finding and drawing", whole_frame},
      {"baseline: a whole frame as version 0.1.0 drew it", earlier_frame}};
  const auto times = in_turns(contenders, 3 * rounds);
  std::printf("| picture of %d × %d | ms |\n|---|---|\n", kPictureWidth, kPictureHeight);
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::printf("| %s | %.2f |\n", contenders[i].name.c_str(), 1e-3 * median(times[i]));
  }
  std::filesystem::remove(file);
  verdicts.measured("drawing the litter through the baseline's drawing", ratio(times[3], times[1]));
  verdicts.measured("a frame as version 0.1.0 drew it through one of today",
                    ratio(times[10], times[9]));
}

}  // namespace pupflow::bench
