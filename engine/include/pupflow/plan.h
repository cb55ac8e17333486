/// @file
/// Which stages a scene needs, and which parts of them. The step is that list and nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pupflow/parameters.h"
#include "pupflow/status.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// Parts of stages that not every scene needs, in the order of their stages.
enum class Part {
  exposure,          ///< contact: which points touch, and the share A of those that do not
  owners,            ///< contact: whose point each of them touches
  pairs,             ///< contact: the list of pairs of pups, and the points without contact
  turn,              ///< steering: what both sides feel, and the turn; not only the direction
  direction,         ///< steering: the direction of travel is set
  sides,             ///< steering: which side each point is on, what both sides feel, and the turn,
                     ///< recorded for an observer
  mean_temperature,  ///< heat: the mean of the touched temperatures
  rotation,          ///< shape matching: the nearest rotation
  quadratic,         ///< shape matching: quadratic terms
  strain,  ///< shape matching: each point's distance from its goal, recorded for an observer
  pose     ///< shape matching: where each pup is and how it is turned, recorded for an observer
};
/// How many there are.
constexpr int kPartCount = 11;

/// A set of parts.
class PartSet {
 public:
  /// No part.
  constexpr PartSet() = default;

  /// These parts.
  constexpr PartSet(std::initializer_list<Part> parts) {
    for (const Part part : parts) add(part);
  }

  /// All parts.
  static constexpr PartSet all() {
    PartSet set;
    set.bits_ = (std::uint32_t{1} << kPartCount) - 1;
    return set;
  }

  /// Whether it has none.
  constexpr bool empty() const { return bits_ == 0; }

  /// Whether it has this one, or all of these.
  ///@{
  constexpr bool has(Part part) const { return (bits_ & bit(part)) != 0; }
  constexpr bool includes(PartSet other) const { return (bits_ & other.bits_) == other.bits_; }
  ///@}

  /// Adds a part.
  constexpr void add(Part part) { bits_ |= bit(part); }

  /// The parts of both.
  friend constexpr PartSet operator|(PartSet a, PartSet b) {
    a.bits_ |= b.bits_;
    return a;
  }
  friend constexpr bool operator==(PartSet, PartSet) = default;

 private:
  static constexpr std::uint32_t bit(Part part) {
    return std::uint32_t{1} << static_cast<int>(part);
  }
  std::uint32_t bits_ = 0;
};

/// All that the contact stage can record.
inline constexpr PartSet kContactRecords{Part::exposure, Part::owners, Part::pairs};

/// The stage that a part belongs to.
Stage stage_of(Part part);

/// What the part is called, e.g. "mean T_c".
std::string_view part_name(Part part);

/// The stages of one step for one parameter set, and the parts of those stages.
struct Plan {
  std::array<bool, kStageCount> stages{};  ///< whether it has each stage
  PartSet parts;                           ///< the parts that it has

  /// Whether it has this stage, or this part.
  ///@{
  bool has(Stage stage) const { return stages[static_cast<std::size_t>(stage)]; }
  bool has(Part part) const { return parts.has(part); }
  ///@}

  /// Adds a stage without its parts, or a part alone.
  ///@{
  void add(Stage stage) { stages[static_cast<std::size_t>(stage)] = true; }
  void add(Part part) { parts.add(part); }
  ///@}

  friend bool operator==(const Plan&, const Plan&) = default;
};

/// Which kinds of actions there are on pups (schedule.h). Heat and turns need stages that the
/// parameters alone may not need.
struct ActionKinds {
  bool force = false;  ///< accelerations
  bool heat = false;   ///< heat beside G
  bool turn = false;   ///< turns in place of their own
};

/// The plan for `params`, which must be sound, where pups are acted on by `actions`. `observed`: the
/// parts whose results are looked at after the step (kContactRecords, Part::sides, Part::strain,
/// Part::pose; fields.h says what each field needs). They change no bit of the litter.
Plan make_plan(const Params& params, PartSet observed, ActionKinds actions = {});

/// What either plan has, and what that reads: turns, sides and mean temperatures read whom each
/// point touches. Parts of stages that neither has are left out.
Plan joined(const Plan& plan, const Plan& more);

/// Whether a stage, or a part of one, is in the step, and the reason in one sentence.
struct Decision {
  Stage stage;               ///< the stage
  std::optional<Part> part;  ///< the part of it; none: the stage itself
  bool needed;               ///< whether it is in the step
  std::string reason;        ///< one sentence
};

/// The same decisions with their reasons, for people: all stages in order, each that is in with its
/// parts behind it.
std::vector<Decision> explain_plan(const Params& params, PartSet observed);

/// `stage` with those of its parts that the scene would need if it needed the stage.
Plan whole_stage(Stage stage, const Params& params, PartSet observed);

}  // namespace pupflow
#pragma GCC visibility pop
