// Trails: where the centre of each pup was over the last seconds, fading into the past.
#include "app/io/text.h"
#include "app/view/overlay.h"

namespace pupflow::view {

void draw_trails(const OverlayScene& scene, Marks& marks) {
  const Ink ink{{150, 40, 90}, 0.9};
  for (std::size_t pup = 0; pup < scene.centres.size(); ++pup) {
    Polyline trail{scene.trails.of(pup), 2.5, ink, true};
    if (trail.points.size() > 1) marks.marks.emplace_back(std::move(trail));
  }
  const std::string seconds = io::number_text(scene.trails.seconds());
  marks.legend.push_back(
      {LegendEntry::Sign::line, ink, {{"path over the last " + seconds + " s"}}});
}

}  // namespace pupflow::view
