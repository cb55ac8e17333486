// Where a camera must stand to take in a whole litter.
#pragma once

#include "app/view/camera.h"
#include "pupflow/parameters.h"

namespace pupflow::view {

/// How high above the floor a framed picture looks: as high as the litter of `params` may lie once
/// it has landed, and as it starts unless that is a column that falls. Known before the first step,
/// so that the camera stands still and a frame looks the same whichever frames come with it; what
/// falls from a column comes from above the picture.
double framed_height(const Params& params);

/// `camera` framing the arena of `params`, with its litter, in a picture of that aspect (see
/// Camera::frame).
Camera framed(Camera camera, const Params& params, double aspect);

}  // namespace pupflow::view
