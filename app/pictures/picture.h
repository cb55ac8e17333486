// A picture of one litter: the scene, and the legend of its colors in a strip beside it. The way
// from a litter to a file is: LitterView (pupflow/view.h), view::DrawList, gl::Renderer, Picture,
// io::write_png.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/context/context.h"
#include "app/gl/renderer.h"
#include "app/io/png.h"
#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/view/color_bar.h"
#include "app/view/draw_list.h"
#include "app/view/marks.h"
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

/// The litter of `params` at t = 0, of which each step records `parts`. Throws
/// Failure(bad_input) with every problem when the parameters are unsound.
Simulation observed_litter(const Params& params, PartSet parts);

/// Pictures of `width` x `height` pixels, with or without a legend.
class Picture {
 public:
  /// Throws Failure(bad_input) when a side or the samples are out of range. There is no legend where
  /// it would take more than half of the picture's width.
  Picture(int width, int height, bool bar, const Look& look);

  /// Width over height of the scene's part, which is as tall as the picture.
  double scene_aspect() const { return static_cast<double>(scene_width_) / height_; }

  /// Call it with the renderer's context current before long work. Throws like `draw`, and where
  /// memory does not suffice.
  void refuse_large() const;

  /// Where the pups were until the next picture, for trails of the look's length.
  void remember(const view::Trails& trails) {
    if (trails.seconds() == look_.trail) trails_ = trails;
  }

  /// Paints these marks, too, beneath the overlays' own, from the next picture on.
  void mark(view::Marks marks) { more_ = std::move(marks); }

  /// Has the next pictures show colors by that scale, of the look's field.
  void set_scale(const view::ColorScale& scale);

  /// Of the words in it, pixels.
  double text_size() const { return style_.text_size; }

  /// The litter as `camera` sees it. In a sequence, automatic scales follow the data within half a
  /// second of the model. The renderer's context must be current. Throws Failure(bad_input) when
  /// the driver allows no picture of that size with the look's samples, Failure(interrupted) after
  /// Ctrl-C.
  io::Image draw(gl::Renderer& renderer, const LitterView& litter, const view::Camera& camera);

  /// What a file carries beside the parameters so that the last picture can be made again.
  io::TextEntries look_entries() const;

 private:
  view::ColorScale scale_for(const LitterView& litter);
  void add_overlays(io::Image& picture, const LitterView& litter, const view::Camera& camera);
  void add_legend(io::Image& picture, double tp);

  int width_, height_;
  bool bar_;
  Look look_;
  view::ColorBarStyle style_;
  view::ColorBarMargins margins_;
  int bar_width_ = 0, scene_width_ = 0;
  view::DrawList list_;
  view::TextPainter text_;
  view::Marks marks_, more_;
  view::Trails trails_;
  std::optional<view::ColorScale> shown_;  // by the last picture
  double shown_at_ = 0;                    // model seconds
};

/// Throws Failure(bad_input) unless 1 <= supersample <= kMostSamples.
void check_samples(int supersample);

/// Throws Failure(bad_input) when a picture of that size is more than OpenGL or the memory allows. An
/// OpenGL context must be current.
void refuse_large(int width, int height);

/// How files name what a picture with this look and this fitted scale shows.
io::TextEntries look_entries(const Look& look, const view::ColorScale& scale);

/// Where a picture was taken from.
io::TextEntries camera_entries(const view::Camera& camera);

/// What of `look` decides how a PNG is written.
io::PngOptions png_options(const Look& look);

/// A scene without background, as the renderer draws it, with colors that are not premultiplied.
void unmultiply(io::Image& scene);

}  // namespace pupflow::pictures
