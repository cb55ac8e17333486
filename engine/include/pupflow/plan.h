// Which stages a scene needs, and which parts of them. The step is that list and nothing else.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// Parts of stages that not every scene needs, in the order of their stages.
enum class Part {
  exposure,          // contacts: which points touch, and the share A of those that do not
  owners,            // contacts: whose point each of them touches
  pairs,             // contacts: the list of pairs of pups, and the points that touch nobody
  turn,              // steering: what both sides feel, and the turn; not only the direction
  mean_temperature,  // heat: the mean of the touched temperatures
  rotation,          // shape matching: the nearest rotation
  quadratic          // shape matching: quadratic terms
};
constexpr int kPartCount = 7;

/// The stage that a part belongs to, and what the part is called.
Stage stage_of(Part part);
std::string_view part_name(Part part);

/// The stages of one step for one parameter set, and the parts of those stages.
struct Plan {
  std::array<bool, kStageCount> stages{};
  std::array<bool, kPartCount> parts{};

  bool has(Stage stage) const { return stages[static_cast<std::size_t>(stage)]; }
  bool has(Part part) const { return parts[static_cast<std::size_t>(part)]; }
  void add(Stage stage) { stages[static_cast<std::size_t>(stage)] = true; }
  void add(Part part) { parts[static_cast<std::size_t>(part)] = true; }
  friend bool operator==(const Plan&, const Plan&) = default;
};

/// The plan for `params` (which must be sound). `observed`: whether anybody looks at exposure,
/// touched pups, touching pairs or what is made from them.
Plan make_plan(const Params& params, bool observed);

/// What either plan has, and what that reads: a turn and a mean temperature read whom each point
/// touches. Parts of stages that neither has are left out.
Plan joined(const Plan& plan, const Plan& more);

/// Whether a stage, or a part of one, is in the step, and the reason in one sentence.
struct Decision {
  Stage stage;
  std::optional<Part> part;
  bool needed;
  std::string reason;
};

/// The same decisions with their reasons, for people: all stages in order, each that is in with its
/// parts behind it.
std::vector<Decision> explain_plan(const Params& params, bool observed);

/// `stage` with those of its parts that the scene would need if it needed the stage.
Plan whole_stage(Stage stage, const Params& params, bool observed);

}  // namespace pupflow
