// Computing the maps of the stability report. A cell has several runs and the median of their
// classes.
#pragma once

#include <vector>

#include "app/report/report.h"
#include "app/report/stability/maps.h"

namespace pupflow::report {

/// The runs of one cell, one per seed; none where the program refuses its parameters.
struct Cell {
  std::vector<Trial> trials;
  std::string refused;  // why, if so

  /// The median of the classes of an odd number of runs, in the order from good to bad.
  Verdict verdict() const;
  /// How many runs have that class.
  int agreeing() const;
  /// The worst of the other classes; empty where all agree.
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
