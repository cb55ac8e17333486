// What the extreme scenes share: the finding that each returns, their parameters, and runs with a
// finding of how they ended.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/report/stability/measure.h"
#include "pupflow/simulation.h"

namespace pupflow::report {

/// The result of a scene.
struct Finding {
  bool ok = false;       // the expected result occurred
  std::string happened;  // one line, with the numbers that were checked
};

}  // namespace pupflow::report

namespace pupflow::report::extreme {

/// The default litter.
Params base(Precision precision);

/// weightless_pup (engine/bodies.h) in this precision.
Params weightless(Precision precision);

bool is_double(Precision precision);

/// Whether all positions, velocities, temperatures, headings and exposed shares are finite.
bool finite(const LitterView& litter);

/// The largest deformation energy (measure.h) of a pup; 0 without pups.
double largest_energy(const std::vector<Shape>& shapes);

/// The smallest volume of a pup, over its volume at rest; 1e300 without pups.
double smallest_volume(const std::vector<Shape>& shapes);

/// Runs `steps` steps. Ok when no status is bad and all numbers are finite. Throws
/// io::Failure(interrupted) after Ctrl-C.
Finding run_fine(Simulation& simulation, std::int64_t steps);

/// Adds the engine's warnings since the start.
void add_warnings(Finding& finding, const Simulation& simulation);

/// Whether the engine has given a warning of this kind.
bool warned(const Simulation& simulation, Warning::Kind kind);

/// Adds a number; not ok unless low <= value <= high.
void require(Finding& finding, const std::string& what, double value, double low, double high);

/// Runs at most `steps` steps; ok when they end in a status of this kind and stage.
Finding run_until(const Params& params, std::int64_t steps, Status::Kind kind, Stage stage);

/// Two findings as one, each after its name; ok when both are.
Finding both(const std::string& one_name, const Finding& one, const std::string& other_name,
             const Finding& other);

/// A run and its name in the report.
struct NamedRun {
  std::string name;
  Params params;
  std::int64_t steps = 0;
};

/// Runs both; ok when the first is fine and the second ends in a status of this kind and stage.
Finding fine_but(const NamedRun& fine, const NamedRun& bad, Status::Kind kind, Stage stage);

}  // namespace pupflow::report::extreme
