// Which stages a scene needs. The step is that list and nothing else.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/params.h"
#include "engine/status.h"

namespace pupflow {

/// Whether one stage is in the step, and the reason in one sentence.
struct PlannedStage {
  Stage stage;
  bool needed;
  std::string reason;
};

/// The stages of one step for one parameter set.
struct Plan {
  std::array<bool, kStageCount> needed{};
  bool quadratic = false;  // shape matching fits quadratic terms, not only a rotation
  bool afferents = false;  // contacts record whom each point touches (for heat, steering, exposure)

  bool has(Stage stage) const { return needed[static_cast<std::size_t>(stage)]; }
  void add(Stage stage) { needed[static_cast<std::size_t>(stage)] = true; }
  friend bool operator==(const Plan&, const Plan&) = default;
};

/// The plan for `params` (which must be sound). `observed` tells whether anybody looks at exposure,
/// groups or flow: without an observer, heat or steering, contacts need not say who touches whom.
Plan make_plan(const Params& params, bool observed);

/// What either plan has. Steering reads whom each point touches, so with it contacts record that.
Plan joined(const Plan& plan, const Plan& more);

/// The same decisions with their reasons, all stages in order; for people.
std::vector<PlannedStage> explain_plan(const Params& params, bool observed);

}  // namespace pupflow
