// The table of extreme scenes: parameters far from the defaults, each with an expected result.
#pragma once

#include <span>
#include <string_view>

#include "app/report/stability/extreme/finding.h"
#include "pupflow/parameters.h"

namespace pupflow::report {

/// One extreme scene.
struct ExtremeScene {
  std::string_view name;                            // one word, for tests and tables
  std::string_view scene;                           // in a few words
  std::string_view expected;                        // one sentence: the expected result
  Finding (*run)(Precision precision, bool quick);  // quick: fewer steps, the same check
};

/// All of them, in the order of the report.
std::span<const ExtremeScene> extreme_scenes();

}  // namespace pupflow::report
