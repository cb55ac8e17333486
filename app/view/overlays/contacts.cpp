// Contact graph: a line between the centres of two touching pups, as wide as the share of their
// points that touch each other.
#include <algorithm>
#include <map>

#include "app/view/overlay.h"

namespace pupflow::view {

void draw_contacts(const OverlayScene& scene, Marks& marks) {
  constexpr double kWidest = 14, kThinnest = 1;  // pixels; where a quarter of the points touch
  const Ink ink{{30, 34, 40}, 0.8};
  const LitterView& litter = scene.litter;
  std::map<std::pair<int, int>, int> points;  // that two pups touch each other with
  for (std::size_t i = 0; i < litter.touched.size(); ++i) {
    const int pup = static_cast<int>(i) / litter.points, other = litter.touched[i];
    if (other >= 0) ++points[std::minmax(pup, other)];
  }
  for (const auto& [first, second] : litter.touching) {
    const double share = points[{first, second}] / (2.0 * litter.points);
    const double width = std::clamp(kWidest * share / 0.25, kThinnest, 2 * kWidest);
    marks.marks.emplace_back(Segment{scene.centres[static_cast<std::size_t>(first)],
                                     scene.centres[static_cast<std::size_t>(second)], width, ink});
  }
  for (const Eigen::Vector3d& centre : scene.centres) {
    marks.marks.emplace_back(Segment{centre, centre, 6, ink});
  }
  marks.legend.push_back({LegendEntry::Sign::line, ink, {{"contact, as wide as its area"}}});
}

}  // namespace pupflow::view
