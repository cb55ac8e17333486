// What an extreme scene comes to.
#pragma once

#include <string>

namespace pupflow::report {

/// What came of a scene.
struct Finding {
  bool ok = false;       // what should happen happened
  std::string happened;  // in one line, with the numbers that decided
};

}  // namespace pupflow::report
