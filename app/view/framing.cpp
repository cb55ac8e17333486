#include "app/view/framing.h"

#include <algorithm>
#include <cmath>

#include "app/view/draw_list.h"
#include "pupflow/geometry.h"

namespace pupflow::view {

double framed_height(const Params& params) {
  const double reach = params.pup_radius + params.point_radius;
  constexpr double kFilled = 0.45;  // the share of the room that bodies in a heap take up
  const double share_of_floor = std::pow(reach / params.arena_radius, 2);
  const double bodies = params.pups * 4.0 / 3.0 * reach * share_of_floor;
  double height = std::max(2 * reach, bodies / kFilled);
  const bool falls_from_afar = params.start == Start::column && params.gravity > 0;
  if (falls_from_afar) return height;
  for (const Eigen::Vector3d& centre : start_centres(params)) {
    height = std::max(height, centre.z() + reach);
  }
  return height;
}

Camera framed(Camera camera, const Params& params, double aspect) {
  camera.frame(params.arena_radius * (1 + kRimWidth), framed_height(params), aspect);
  return camera;
}

}  // namespace pupflow::view
