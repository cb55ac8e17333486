// What pictures and the window share: how a litter is shown, where a file goes, and the limits.
#pragma once

#include <cstddef>
#include <string>

#include "app/view/color_scale.h"
#include "app/view/drawing.h"
#include "app/view/overlay.h"

namespace pupflow::pictures {

/// The sides that a picture or a window may have, in pixels; samples across a pixel; the edge of a
/// panel of a sheet, and the panels that one may have.
constexpr int kSmallestSide = 16, kLargestSide = 16384;
constexpr int kMostSamples = 8;
constexpr int kMostDpi = 4800;
constexpr double kLongestTrail = 1000;  // model seconds
constexpr int kSmallestPanel = 120, kLargestPanel = 4096;
constexpr std::size_t kMostPanels = 100;

/// Options that every picture and window shares.
struct Look {
  view::ColorScale scale;  // the field that the colors show, color map, range
  view::Draw draw = view::Draw::skin;
  view::Quality quality = view::Quality::normal;
  view::OverlaySet overlays;
  double trail = 1;          // model seconds that trails are long
  bool caption = false;      // a line that says what is shown
  bool celsius = false;      // temperatures in degrees, too
  bool transparent = false;  // no paper behind the scene
  int dpi = 0;               // dots per inch that files name; 0: none
  std::string shader_dir;    // read shaders from here instead of the embedded ones
  int supersample = 0;       // n x n samples per pixel; 0: those of the quality
  bool verbose = false;      // print which context and renderer were chosen

  int samples() const { return supersample != 0 ? supersample : view::usual_samples(quality); }

  /// What a step must record for the colors and overlays.
  PartSet parts() const { return scale.field->parts | overlays.parts(); }
};

struct Output {
  std::string path;
  bool force = false;  // overwrite
  bool quiet = false;
};

}  // namespace pupflow::pictures
