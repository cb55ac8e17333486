// The number of each pup, as files have it.
#include "app/view/overlay.h"

namespace pupflow::view {

void draw_ids(const OverlayScene& scene, Marks& marks) {
  const Ink ink{{10, 12, 16}};
  const double up = scene.litter.params.pup_radius;
  for (std::size_t pup = 0; pup < scene.centres.size(); ++pup) {
    const Eigen::Vector3d at = scene.centres[pup] + Eigen::Vector3d(0, 0, up);
    marks.marks.emplace_back(Label{at, {{std::to_string(pup)}}, 17, ink});
  }
  marks.legend.push_back({LegendEntry::Sign::label, ink, {{"number of the pup"}}});
}

}  // namespace pupflow::view
