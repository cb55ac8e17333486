// Pictures: drawing, reading back, encoding.
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/io/png.h"
#include "app/pictures/studio.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"

namespace pupflow::bench {
namespace {

constexpr int kWidth = 1280, kHeight = 960;
constexpr const char* kCamera = "orbit:30,35";  // what `pupflow render` takes

/// A studio and a litter before its camera.
struct Sitting {
  Sitting(const Params& params, int supersample)
      : simulation(after(params, kSettled)),
        camera(pictures::framed_camera(kCamera, params, double{kWidth} / kHeight)),
        studio(look(supersample)) {}

  static pictures::Look look(int supersample) {
    pictures::Look look;
    look.supersample = supersample;
    return look;
  }
  io::Image shoot() { return studio.shoot(simulation, camera, kWidth, kHeight); }

  Simulation simulation;
  view::Camera camera;
  pictures::Studio studio;
};

}  // namespace

void pictures(int rounds, Verdicts& verdicts) {
  setenv("LP_NUM_THREADS", "1", 0);  // software OpenGL: one core, as everything else here
  Params empty = huddling(Precision::float_);
  empty.pups = 0;
  const Params full = huddling(Precision::float_);
  Sitting floor(empty, 1), plain(full, 1), fine(full, 2);
  const std::string file = (std::filesystem::temp_directory_path() / "pupflow-bench.png").string();
  const io::Image frame = fine.shoot();
  const std::vector<Contender> contenders = {
      {"the arena alone", [&] { return microseconds([&] { floor.shoot(); }); }},
      {"a litter, 1 sample a pixel", [&] { return microseconds([&] { plain.shoot(); }); }},
      {"a litter, 2 × 2 samples", [&] { return microseconds([&] { fine.shoot(); }); }},
      {"PNG to a file",
       [&] { return microseconds([&] { io::write_png(file, frame, {}, true); }); }}};
  const auto times = in_turns(contenders, 3 * rounds);
  std::printf("| picture of %d × %d | ms |\n|---|---|\n", kWidth, kHeight);
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::printf("| %s | %.1f |\n", contenders[i].name.c_str(), 1e-3 * median(times[i]));
  }
  std::filesystem::remove(file);
  // The best way of drawing that was tried at the start took 18.5 ms where the floor took 4.4.
  verdicts.at_most("a litter's picture through the arena's", 1.3 * 18.5 / 4.4,
                   ratio(times[1], times[0]));
}

}  // namespace pupflow::bench
