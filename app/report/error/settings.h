// The settings that the scenes of the error report are computed with.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/report/error/scene.h"

namespace pupflow::report {

/// A rotation that maps no coordinate axis near another, so that no symmetry hides an error.
Eigen::Matrix3d oblique_rotation();

/// `params` with a step of 0.01 / parts and consistent refinement.
Setting refined(const Params& params, int parts);

/// Settings with steps 0.01, 0.005, ..., 0.01 / finest.
std::vector<Setting> halved(const Params& params, int finest);

/// The same with naive refinement, and from 0.02 on.
std::vector<Setting> halved_naively(const Params& params, int finest);

/// The curves of every scene of bodies: consistent and naive refinement, consistent refinement in
/// float, and the explicit integrator, down to steps of 0.01 / finest.
std::vector<Curve> usual_curves(const Params& params, int finest);

/// Sets reference and finer of a scene: double, with steps of 0.01 / parts and half of that.
void set_reference(ErrorScene& scene, const Params& params, int parts);

/// Pups of k points along a face edge, against one of many points at the same step.
Aside points_aside(const Params& params, bool quick, std::vector<std::size_t> quantities);

}  // namespace pupflow::report
