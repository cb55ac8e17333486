// Directions of travel: an arrow from each pup's centre, a little longer than its body.
#include <cmath>

#include "app/view/overlay.h"

namespace pupflow::view {

void draw_headings(const OverlayScene& scene, Marks& marks) {
  const Ink ink{{20, 24, 30}};
  const Params& params = scene.litter.params;
  const double reach = params.pup_radius + params.point_radius;
  for (std::size_t pup = 0; pup < scene.centres.size(); ++pup) {
    const double heading = scene.litter.heading[pup];
    const Eigen::Vector3d along(std::cos(heading), std::sin(heading), 0);
    const Eigen::Vector3d from = scene.centres[pup] + Eigen::Vector3d(0, 0, reach);
    marks.marks.emplace_back(
        Arrow{from + 0.3 * reach * along, from + 1.2 * reach * along, 2.5, ink});
  }
  marks.legend.push_back({LegendEntry::Sign::arrow, ink, {{"direction of travel"}}});
}

}  // namespace pupflow::view
