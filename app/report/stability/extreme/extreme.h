// What the extreme scenes share: parameters to begin with, runs that say how they ended, clouds
// taken out of a simulation and put into it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "app/report/stability/extreme/scenes.h"
#include "app/report/stability/measure.h"
#include "pupflow/simulation.h"

namespace pupflow::report::extreme {

/// The points of one pup.
using Cloud3 = std::vector<Eigen::Vector3d>;

/// The default litter.
Params base(Precision precision);

/// One pup far from floor and wall that nothing pushes.
Params weightless(Precision precision);

bool is_double(Precision precision);

/// Whether all positions, velocities, temperatures, headings and exposed shares are finite.
bool finite(const Simulation& simulation);

/// The largest deformation energy (stability_measure.h) of a pup; 0 of nobody.
double largest_energy(const std::vector<Shape>& shapes);

/// The smallest volume of a pup, over its volume at rest; 1e300 of nobody.
double smallest_volume(const std::vector<Shape>& shapes);

/// Runs and says how it ended, and what the engine warned of; ok when no number went bad and all
/// are finite. Throws io::Failure(interrupted) when Ctrl-C came.
Finding run_fine(Simulation& simulation, std::int64_t steps);

/// Adds what the engine has warned of since the start, if anything.
void add_warnings(Finding& finding, const Simulation& simulation);

/// Whether it has warned of this.
bool warned(const Simulation& simulation, Warning::Kind kind);

/// Adds a number that must be within limits.
void demand(Finding& finding, const std::string& what, double value, double low, double high);

/// Runs until a status of this kind and stage; ok when it comes.
Finding run_until(const Params& params, std::int64_t steps, Status::Kind kind, Stage stage);

/// Two findings as one, each after its name; ok when both are.
Finding both(const std::string& one_name, const Finding& one, const std::string& other_name,
             const Finding& other);

/// A run and what the report calls it.
struct NamedRun {
  std::string name;
  Params params;
  std::int64_t steps = 0;
};

/// Runs both; ok when the first goes fine and the second ends in a status of this kind and stage.
Finding fine_but(const NamedRun& fine, const NamedRun& bad, Status::Kind kind, Stage stage);

/// Puts a pup's points there, all with the same velocity.
void place(Simulation& simulation, int pup, const Cloud3& cloud,
           const Eigen::Vector3d& velocity = {0, 0, 0});

/// Where a pup's points are.
Cloud3 cloud_of(const Simulation& simulation, int pup);

}  // namespace pupflow::report::extreme
