// Putting pups where a scene wants them, stepping them, and looking at their shape.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "app/report/error/scene.h"
#include "pupflow/simulation.h"

namespace pupflow::report {

using Points = std::vector<Eigen::Vector3d>;

/// Model seconds between samples. All steps of the scenes go into it a whole number of times.
constexpr double kSample = 0.02;

/// Some rotation that lines up with no axis, so that no symmetry hides an error.
Eigen::Matrix3d oblique_rotation();

/// The rest offsets of a pup, turned by `rotation`.
Points rest_points(const Params& params, const Eigen::Matrix3d& rotation);

/// Puts a pup's points at `offsets` round `centre`, with velocities of their own.
void place(Simulation& simulation, int pup, const Eigen::Vector3d& centre, const Points& offsets,
           const Points& velocities);

/// The points of one pup, or their velocities.
Points points_of(const Simulation& simulation, int pup);
Points velocities_of(const Simulation& simulation, int pup);

/// What fits a pup's points best: centre and rotation of the rest offsets, and what is left.
struct Pose {
  Eigen::Vector3d centre;
  Eigen::Matrix3d rotation;
  double strain;  // mean squared distance of the points from the turned rest offsets, over r_pup^2
};
Pose pose_of(const Simulation& simulation, int pup);

/// Processor time of the calling thread: its wall time, but for the turns of others on the machine.
double thread_seconds();

/// Adds one value to each quantity of the trajectory.
using Look = std::function<void(const Simulation&, Trajectory&)>;

/// Steps `simulation` through `samples` times kSample and looks after each. `between` steps, when
/// given, edits the simulation; only the steps' time counts. Throws io::Failure(interrupted).
Outcome run_sampled(Simulation& simulation, int samples, std::size_t quantities, const Look& look,
                    const std::function<void(Simulation&)>& between = {});

/// `params` with a step of 0.01 / parts and consistent refinement.
Setting refined(const Params& params, int parts);

/// Settings with steps 0.01, 0.005, ..., 0.01 / finest.
std::vector<Setting> halved(const Params& params, int finest);

/// The same with alpha taken as it is, from 0.02 on.
std::vector<Setting> halved_naively(const Params& params, int finest);

/// What every scene of bodies is computed with: consistent and naive refinement, consistent
/// refinement in float, and the explicit integrator, down to steps of 0.01 / finest.
std::vector<Curve> usual_curves(const Params& params, int finest);

/// Sets reference and finer of a scene: double, with steps of 0.01 / parts and half of that.
void set_reference(Scene& scene, const Params& params, int parts);

/// Pups of k points along a face edge, against one of many points at the same step.
Aside points_aside(const Params& params, bool quick, std::vector<std::size_t> quantities);

}  // namespace pupflow::report
