// Forces: the drive of each pup, and how far contacts push its centre, both to a scale of their
// own. The push is that of the contact rule at the present positions:
//
//   push = mean over the pup's points of (p - p_b) (2 r - d), p_b being the nearest touching point
//   of another pup, for points that are above theirs: only the upper one moves
#include <cmath>

#include "app/view/overlay.h"

namespace pupflow::view {

namespace {

std::vector<Eigen::Vector3d> pushes(const LitterView& litter) {
  const auto points = static_cast<std::size_t>(litter.points);
  const double reach = 2 * litter.params.point_radius;
  std::vector<Eigen::Vector3d> pushes(static_cast<std::size_t>(litter.pups),
                                      Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < litter.touched.size(); ++i) {
    const int other = litter.touched[i];
    if (other < 0) continue;
    const int pup = static_cast<int>(i / points);
    const Eigen::Vector3d place = litter.positions(pup, static_cast<int>(i % points));
    Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
    double distance = reach;
    for (int p = 0; p < litter.points; ++p) {
      const Eigen::Vector3d away = place - litter.positions(other, p);
      if (away.squaredNorm() < distance * distance) distance = away.norm(), nearest = away;
    }
    const bool upper = nearest.z() > 0 || (nearest.z() == 0 && pup < other);
    if (upper) {
      pushes[static_cast<std::size_t>(pup)] += nearest * (reach - distance) / litter.points;
    }
  }
  return pushes;
}

}  // namespace

void draw_forces(const OverlayScene& scene, Marks& marks) {
  const Ink drive{{0, 90, 160}}, contact{{190, 60, 0}};
  const Params& params = scene.litter.params;
  const double reach = params.pup_radius + params.point_radius;
  const std::vector<Eigen::Vector3d> pushed = pushes(scene.litter);
  double longest = 0;
  for (const Eigen::Vector3d& push : pushed) longest = std::max(longest, push.norm());
  for (std::size_t pup = 0; pup < scene.centres.size(); ++pup) {
    const double heading = scene.litter.heading[pup];
    const Eigen::Vector3d along(std::cos(heading), std::sin(heading), 0);
    const Eigen::Vector3d& centre = scene.centres[pup];
    if (params.drive > 0) {
      marks.marks.emplace_back(Arrow{centre, centre + 1.2 * reach * along, 3, drive});
    }
    if (longest > 0) {
      marks.marks.emplace_back(
          Arrow{centre, centre + 2 * reach / longest * pushed[pup], 3, contact});
    }
  }
  marks.legend.push_back({LegendEntry::Sign::arrow, drive, {{"drive"}}});
  marks.legend.push_back({LegendEntry::Sign::arrow, contact, {{"push by contacts"}}});
}

}  // namespace pupflow::view
