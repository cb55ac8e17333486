// What is to be on a sheet of panels.
#pragma once

#include <string>
#include <vector>

#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "pupflow/parameters.h"

namespace pupflow::pictures {

/// A parameter that panels differ in, by name, and its values.
struct Axis {
  std::string parameter;
  std::vector<double> values;
};

/// `pupflow render --grid`: a panel for each value of one parameter, or for each pair of two.
struct SheetJob {
  Params params;           // everything but the varied parameters
  std::vector<Axis> axes;  // one or two: the first goes across, a second one down
  int panel = 560;         // edge of a panel, pixels
  view::Camera camera = view::Camera::parse(view::Camera::kUsual);
  bool bar = true;          // draw the legend of the colors
  bool own_scales = false;  // a scale and a legend for each panel
  int threads = 1;          // that step the litters
  Look look;
  Output output;
  std::string verb;         // for progress and messages
  io::TextEntries entries;  // what the file says of itself; the first is called picture
};

}  // namespace pupflow::pictures
