#include "app/window/selection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace pupflow::window {
namespace {

constexpr double kEyeView = 75 * std::numbers::pi / 180;  // from bottom to top

/// Calls `use` with each of a pup's points whose numbers are good.
template <class Use>
void for_good_points(const LitterView& litter, int pup, const Use& use) {
  for (int i = 0; i < litter.points; ++i) {
    const Eigen::Vector3d point = litter.positions(pup, i);
    if (point.allFinite()) use(point);
  }
}

}  // namespace

int next_pup(std::optional<int> selected, int pups, int by) {
  if (!selected) return by < 0 ? pups - 1 : 0;
  const int next = (*selected + by) % pups;
  return next < 0 ? next + pups : next;
}

std::optional<Eigen::Vector3d> middle_of(const LitterView& litter, int pup) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int good = 0;
  for_good_points(litter, pup, [&](const Eigen::Vector3d& point) {
    sum += point;
    ++good;
  });
  if (good == 0) return {};
  return sum / good;
}

void mark_pup(const LitterView& litter, int pup, const view::Camera& camera, view::Marks& marks) {
  constexpr int kCorners = 64;
  constexpr double kRoom = 1.08;  // between body and ring
  const view::Ink paper{{255, 255, 255}}, ink{{16, 18, 22}};
  const auto middle = middle_of(litter, pup);
  if (!middle) return;
  double reach = 0;
  for_good_points(litter, pup, [&](const Eigen::Vector3d& point) {
    reach = std::max(reach, (point - *middle).norm());
  });
  reach = kRoom * (reach + litter.params.point_radius);
  view::Polyline ring{{}, 6, paper};
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    ring.points.push_back(
        *middle + reach * (std::cos(angle) * camera.right() + std::sin(angle) * camera.up()));
  }
  marks.marks.emplace_back(ring);
  ring.width = 2.5;
  ring.ink = ink;
  marks.marks.emplace_back(ring);
  const Eigen::Vector3d above = *middle + 1.25 * reach * camera.up();
  marks.marks.emplace_back(view::Label{above, {{std::to_string(pup)}}, 22, ink});
}

void mark_pull(const LitterView& litter, int pup, const Eigen::Vector3d& target,
               view::Marks& marks) {
  const auto middle = middle_of(litter, pup);
  if (!middle) return;
  marks.marks.emplace_back(view::Segment{*middle, target, 6, {{255, 255, 255}}});
  marks.marks.emplace_back(view::Segment{*middle, target, 3, {{190, 110, 20}}});
  marks.marks.emplace_back(view::Segment{target, target, 12, {{190, 110, 20}}});
}

view::Camera eye_of(const LitterView& litter, int pup) {
  constexpr double kBefore = 1.05;  // of the way from the middle to the front
  const Params& params = litter.params;
  const double heading = litter.heading[static_cast<std::size_t>(pup)];
  const double azimuth = std::isfinite(heading) ? heading : 0;
  const Eigen::Vector3d along(std::cos(azimuth), std::sin(azimuth), 0);
  const Eigen::Vector3d middle = middle_of(litter, pup).value_or(Eigen::Vector3d::Zero());
  double front = params.pup_radius;  // a body that is pressed flat in front does not pull it back
  for_good_points(litter, pup, [&](const Eigen::Vector3d& point) {
    front = std::max(front, (point - middle).dot(along));
  });
  const Eigen::Vector3d eye = middle + kBefore * (front + params.point_radius) * along;
  return view::Camera::along(eye, azimuth, params.pup_radius, kEyeView);
}

view::Camera CameraGuide::lead(const view::Camera& camera, CameraMode mode, std::optional<int> pup,
                               const LitterView& litter) {
  const bool there = pup && *pup < litter.pups;
  if (mode == CameraMode::eye && there) {
    if (!before_) before_ = camera;
    return eye_of(litter, *pup);
  }
  view::Camera led = before_.value_or(camera);
  before_.reset();
  if (mode == CameraMode::follow && there) {
    if (const auto middle = middle_of(litter, *pup)) led.look_at(*middle);
  }
  return led;
}

}  // namespace pupflow::window
