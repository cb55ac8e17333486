// Pictures as arrays, drawn by the graphics module.
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <utility>

#include "pupflow/view.h"

namespace pupflow::python {

/// How a picture looks; the options of `pupflow render` of the same names.
struct Look {
  int width = 0, height = 0;
  std::string color_by;
  std::optional<std::string> colormap;
  std::optional<std::pair<double, double>> scale;
  std::string camera;
  bool bar = true;
};

/// An array (height, width, 3) of uint8, drawn without the GIL. Throws io::Failure: bad_input, and
/// no_context when there is no graphics module or no OpenGL.
pybind11::array draw(const LitterView& litter, const Look& look);

}  // namespace pupflow::python
