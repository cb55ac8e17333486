// The class of a run on the maps of the stability report: one of nine, by measurements of its last
// quarter, and by statuses and warnings of the engine.
//
// The default litter must be stable at every temperature; the report prints its numbers beside the
// limits.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow::report {

/// From good to bad. A run gets the worst of those that apply.
enum class Verdict {
  stable,
  ringing,
  overlapping,
  heating,
  hanging,
  sunk,
  inverted,
  escaped,
  diverged
};
constexpr int kVerdicts = 9;

/// One run, and measurements of its last quarter.
struct Trial {
  Verdict verdict = Verdict::stable;
  Status status;                  // when bad, the numbers below are 0
  std::vector<Warning> warnings;  // of the engine, the first of each kind
  double energy = 0;              // mean deformation energy (measure.h)
  double swing = 0;               // its standard deviation in time, mean over pups
  /// Mean kinetic energy of a pup over the largest energy that it can gain in the second half: by
  /// the drive across the arena and a fall from the height z of the highest pup at half time,
  /// 2 f r_arena + g z.
  double kinetic = 0;
  double nearest = 0;   // the nearest other centre over 2 r_pup, mean over pups; 0 below two pups
  double inside = 0;    // share of all points that lie inside another body (pupflow/overlap.h)
  double inverted = 0;  // share of samples whose fitted linear map has a determinant below 0
};

/// The criteria of a class. A run belongs to it when any of them holds.
struct Class {
  std::string_view name;
  std::string_view meaning;          // for the page
  double Trial::*measure = nullptr;  // belongs when this is over the limit
  double limit = 0;
  std::optional<Warning::Kind> warning;      // belongs when the engine has warned of this
  Status::Kind status = Status::Kind::fine;  // belongs when a step ended so
  std::string_view color;                    // on the maps
};

/// All classes in the order of Verdict.
std::span<const Class> classes();
inline const Class& class_of(Verdict verdict) {
  return classes()[static_cast<std::size_t>(verdict)];
}

/// Runs `params.steps` steps and classifies the run. Empty when `stop`, which is called every 50
/// steps, returns true.
std::optional<Trial> try_litter(const Params& params, const std::function<bool()>& stop);

/// A trial that ended in a bad status.
Trial lost(const Status& status);

}  // namespace pupflow::report
