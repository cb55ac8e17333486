// Computing the maps of the stability report: each cell some runs, called by what most of them are.
#pragma once

#include <vector>

#include "app/report/report.h"
#include "app/report/stability/maps.h"

namespace pupflow::report {

/// The runs of one cell, one per seed; none where the program refuses its parameters.
struct Cell {
  std::vector<Trial> trials;
  std::string refused;  // why, if so

  /// What most seeds say: the middle one of an odd number, in the order from good to bad. A
  /// majority holds the middle.
  Verdict verdict() const;
  /// How many seeds say so.
  int agreeing() const;
  /// The worst of what the others say; nothing where all agree.
  std::optional<Verdict> other() const;
  /// Mean of a measure over the runs that ended; 0 where none did.
  double mean(double Trial::*measure) const;
  /// The first run that a bad status ended, or nullptr.
  const Trial* lost() const;
};

/// The cells of a map: [method][y][x].
using MapResult = std::vector<std::vector<std::vector<Cell>>>;

/// Computes all cells on `options.threads` threads; no bit depends on how many. Throws
/// io::Failure(interrupted).
MapResult compute_map(const StabilityMap& map, const Options& options);

}  // namespace pupflow::report
