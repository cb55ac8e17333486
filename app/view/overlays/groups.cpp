// Groups of touching pups: the hull of each on the floor, and how many pups it has.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/view/overlay.h"
#include "pupflow/fields.h"

namespace pupflow::view {

namespace {

using Place = Eigen::Vector2d;

double turn(const Place& a, const Place& b, const Place& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Place> hull_of(std::vector<Place> places) {
  std::ranges::sort(places, [](const Place& a, const Place& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Place> hull;
  const auto add = [&](const Place& place, std::size_t least) {
    while (hull.size() >= least + 2 && turn(hull[hull.size() - 2], hull.back(), place) <= 0) {
      hull.pop_back();
    }
    hull.push_back(place);
  };
  for (const Place& place : places) add(place, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto place = places.rbegin() + 1; place != places.rend(); ++place) add(*place, lower);
  hull.pop_back();
  return hull;
}

}  // namespace

void draw_groups(const OverlayScene& scene, Marks& marks) {
  constexpr int kAround = 24;      // points of the outline around a pup
  constexpr double kMargin = 1.2;  // of the outline, in pup radii
  const Ink outline{{20, 24, 30}, 0.85}, inside{{20, 24, 30}, 0.06}, ink{{20, 24, 30}};
  const Params& params = scene.litter.params;
  const double reach = kMargin * (params.pup_radius + params.point_radius);
  const std::vector<int> labels = group_labels(scene.litter.pups, scene.litter.touching);
  const std::vector<int> sizes = group_sizes(labels);
  for (std::size_t group = 0; group < sizes.size(); ++group) {
    if (sizes[group] < 2) continue;
    std::vector<Place> places;
    Place tip(0, -1e300);  // where the number stands
    for (std::size_t pup = 0; pup < labels.size(); ++pup) {
      if (labels[pup] != static_cast<int>(group)) continue;
      for (int i = 0; i < kAround; ++i) {
        const double angle = 2 * std::numbers::pi * i / kAround;
        places.emplace_back(scene.centres[pup].head<2>() +
                            reach * Place(std::cos(angle), std::sin(angle)));
      }
    }
    Polygon polygon{{}, 2, outline, inside};
    for (const Place& place : hull_of(std::move(places))) {
      polygon.corners.emplace_back(place.x(), place.y(), 0);
      if (place.y() > tip.y()) tip = place;
    }
    marks.marks.emplace_back(std::move(polygon));
    marks.marks.emplace_back(
        Label{{tip.x(), tip.y(), 0}, {{std::to_string(sizes[group])}}, 20, ink});
  }
  marks.legend.push_back({LegendEntry::Sign::area, outline, {{"group, with its number of pups"}}});
}

}  // namespace pupflow::view
