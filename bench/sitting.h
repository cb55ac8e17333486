// A litter before a camera.
#pragma once

#include <memory>

#include "app/context/context.h"
#include "app/gl/renderer.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"
#include "bench/plain_frame.h"
#include "bench/scenes.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {

constexpr int kPictureWidth = 1280, kPictureHeight = 960;

/// The pictures that `pupflow render` takes of a litter, without their color bar, in the parts that
/// they are made of. One at a time.
class Sitting {
 public:
  /// Of litters in the arena of `params`. Throws io::Failure without OpenGL.
  explicit Sitting(const Params& params = huddling(Precision::float_), int width = kPictureWidth,
                   int height = kPictureHeight);

  /// What is seen of `simulation` becomes the list that is drawn.
  void list(const Simulation& simulation, const view::Drawing& drawing = {});

  /// The same for `draw_plainly`, and for pictures as version 0.1.0 drew them: spheres with hard
  /// edges, without shadows, of which `draw` took 2 x 2 samples.
  void list_points(const Simulation& simulation) {
    list(simulation, {.draw = view::Draw::points, .quality = view::Quality::fast});
  }

  /// Uploads the list and draws it, to the last pixel.
  void draw(int supersample);

  /// The same by the baseline, one sample a pixel.
  void draw_plainly();

  /// Reads the picture back.
  io::Image read() const { return target_.read(); }

 private:
  std::unique_ptr<context::Context> context_;  // outlives what was made in it
  gl::Renderer renderer_;
  PlainFrame plain_;
  gl::Target target_;
  view::ColorScale scale_;
  view::Camera camera_;
  view::DrawList list_;
};

}  // namespace pupflow::bench
