// What pictures and the window share: how a litter is shown, where a file goes, and the limits.
#pragma once

#include <string>

#include "app/view/color_scale.h"

namespace pupflow::pictures {

/// The sides that a picture or a window may have, in pixels; samples across a pixel; the edge of a
/// panel of Figure 1.
constexpr int kSmallestSide = 16, kLargestSide = 16384;
constexpr int kMostSamples = 8;
constexpr int kSmallestPanel = 120, kLargestPanel = 4096;

/// Options that every picture and window shares.
struct Look {
  view::ColorScale scale;  // the field that the colors show, color map, range
  std::string shader_dir;  // read shaders from here instead of the embedded ones
  int supersample = 2;     // n x n samples per pixel
  bool verbose = false;    // print which context and renderer were chosen
};

struct Output {
  std::string path;
  bool force = false;  // overwrite
  bool quiet = false;
};

}  // namespace pupflow::pictures
