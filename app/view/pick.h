// What lies under a place of a picture: a line of sight against the bodies of a litter.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "app/view/camera.h"
#include "pupflow/view.h"

namespace pupflow::view {

/// A half line in arena units; `along` has length 1.
struct Ray {
  Eigen::Vector3d from, along;
};

/// The line of sight through a place of a picture of that aspect (width / height). `x` and `y` are
/// shares of its width and height from the upper left corner. Without perspective it begins far
/// behind the eye.
Ray sight(const Camera& camera, double aspect, double x, double y);

/// The pup whose body `ray` meets first, if it meets any. A body is the skin that pictures show, one
/// point radius outside the points; where some of a pup's points are not finite, balls around the
/// others.
std::optional<int> pick(const LitterView& litter, const Ray& ray);

}  // namespace pupflow::view
