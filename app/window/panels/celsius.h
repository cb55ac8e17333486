// The model's temperatures as they are on a thermometer.
#pragma once

#include <string>

#include "app/io/text.h"

namespace pupflow::window {

/// 0.6, the preferred temperature of the paper, stands for 37 degrees (docs/model.md).
constexpr double kCelsiusPerUnit = 37 / 0.6;

inline std::string celsius_text(double temperature) {
  return io::formatted("%.1f \u00b0C", kCelsiusPerUnit * temperature);
}

}  // namespace pupflow::window
