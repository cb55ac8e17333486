// What a run is called on the maps of the stability report: one of nine classes, by what its bodies
// do in its last quarter and by what the engine says.
//
// The default litter has to be called stable at every temperature; the report prints its numbers
// beside the limits.
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

/// From good to bad. A run that is several of these is called the worst.
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

/// One run and what was seen in its last quarter.
struct Trial {
  Verdict verdict = Verdict::stable;
  Status status;                  // when bad, the numbers below are 0
  std::vector<Warning> warnings;  // of the engine, the first of each kind
  double energy = 0;              // mean deformation energy (stability_measure.h)
  double swing = 0;               // its standard deviation in time, mean over pups
  /// Mean kinetic energy of a pup, as a share of what a pup can have got since half time: from the
  /// drive across the arena and from a fall from where the highest pup was, f 2 r_arena + g z.
  double kinetic = 0;
  double nearest = 0;   // the nearest other centre over 2 r_pup, mean over pups; 0 below two pups
  double inside = 0;    // share of all points that lie inside another body (engine/overlap.h)
  double inverted = 0;  // share of looks at a pup whose fitted linear map has a determinant below 0
};

/// What makes a run belong to a class. Several of these may, and any will do.
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

/// Runs `params.steps` steps and judges. Nothing when `stop`, asked now and then, says so.
std::optional<Trial> try_litter(const Params& params, const std::function<bool()>& stop);

/// A trial that ended in a bad status.
Trial lost(const Status& status);

}  // namespace pupflow::report
