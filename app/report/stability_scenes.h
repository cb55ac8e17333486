// Scenes far outside the ordinary, each with what should happen.
#pragma once

#include <span>
#include <string_view>

#include "app/report/finding.h"
#include "pupflow/parameters.h"

namespace pupflow::report {

/// One extreme scene.
struct ExtremeScene {
  std::string_view name;                            // one word, for tests and tables
  std::string_view scene;                           // in a few words
  std::string_view expected;                        // one sentence: what should happen
  Finding (*run)(Precision precision, bool quick);  // quick: fewer steps, the same check
};

/// All of them, in the order of the report.
std::span<const ExtremeScene> extreme_scenes();

}  // namespace pupflow::report
