// A picture of one litter: the scene, and the legend of its colors in a strip beside it. The way
// from a litter to a file is: LitterView (pupflow/view.h), view::DrawList, gl::Renderer, Picture,
// io::write_png.
#pragma once

#include <memory>

#include "app/context/context.h"
#include "app/gl/renderer.h"
#include "app/io/png.h"
#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/view/color_bar.h"
#include "app/view/draw_list.h"
#include "app/view/text.h"
#include "pupflow/simulation.h"

namespace pupflow::pictures {

/// A renderer with an OpenGL context of its own that needs no display. For the thread that made it.
struct Headless {
  /// Throws Failure: no_context without OpenGL, bad_input and bad_file for bad shaders. Prints the
  /// choice of context when `look.verbose`.
  explicit Headless(const Look& look);

  std::unique_ptr<context::Context> context;  // outlives the renderer's objects
  std::unique_ptr<gl::Renderer> renderer;
};

/// The litter of `params` at t = 0, of which each step records what `field` needs. Throws
/// Failure(bad_input) with every problem when the parameters are unsound.
Simulation observed_litter(const Params& params, const Field& field);

/// Pictures of `width` x `height` pixels, with or without a legend.
class Picture {
 public:
  /// Throws Failure(bad_input) when a side or the samples are out of range or the legend leaves no
  /// room for the scene.
  Picture(int width, int height, bool bar, const Look& look);

  /// Width over height of the scene's part, which is as tall as the picture.
  double scene_aspect() const { return static_cast<double>(scene_width_) / height_; }

  /// Call it with the renderer's context current before long work. Throws like `draw`, and where
  /// memory does not suffice.
  void refuse_large() const;

  /// The litter as `camera` sees it. The renderer's context must be current. Throws
  /// Failure(bad_input) when the driver allows no picture of that size with the look's samples.
  io::Image draw(gl::Renderer& renderer, const LitterView& litter, const view::Camera& camera);

  /// What a file carries beside the parameters so that the last picture can be made again.
  io::TextEntries look_entries() const;

 private:
  io::Image with_legend(const io::Image& scene, double tp);

  int width_, height_;
  bool bar_;
  view::ColorScale scale_;
  int supersample_;
  view::ColorBarStyle style_;
  view::ColorBarMargins margins_;
  int bar_width_ = 0, scene_width_ = 0;
  view::DrawList list_;
  view::TextPainter text_;
};

/// Throws Failure(bad_input) unless 1 <= supersample <= kMostSamples.
void check_samples(int supersample);

/// Throws Failure(bad_input) when a picture of that size, of which a part of `drawn_width` x
/// `drawn_height` pixels is drawn at a time, is more than OpenGL or the memory allows. An OpenGL
/// context must be current.
void refuse_large(int width, int height, int drawn_width, int drawn_height, int supersample);

/// How files name the field, the colors and the samples of a picture with this fitted scale.
io::TextEntries look_entries(const view::ColorScale& scale, int supersample);

}  // namespace pupflow::pictures
