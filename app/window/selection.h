// The pup that the window points at: which one comes next, its mark in the arena, its camera.
#pragma once

#include <optional>

#include "app/view/camera.h"
#include "app/view/marks.h"
#include "app/window/controls.h"
#include "pupflow/view.h"

namespace pupflow::window {

/// The pup `by` places after `selected` in a litter of `pups` >= 1, round and round; without a
/// selection the first one, and the last one for negative `by`.
int next_pup(std::optional<int> selected, int pups, int by);

/// The middle of those of a pup's points whose numbers are good; none: there are none.
std::optional<Eigen::Vector3d> middle_of(const LitterView& litter, int pup);

/// Adds a ring round a pup as `camera` sees it, and its number.
void mark_pup(const LitterView& litter, int pup, const view::Camera& camera, view::Marks& marks);

/// Adds a line from a pup to where it is pulled.
void mark_pull(const LitterView& litter, int pup, const Eigen::Vector3d& target,
               view::Marks& marks);

/// A camera that looks along a pup's heading from in front of its body.
view::Camera eye_of(const LitterView& litter, int pup);

/// Leads the camera while it follows a pup or looks out of its eyes.
class CameraGuide {
 public:
  /// What `camera` becomes in this mode. Looking out of a pup's eyes ends where it began.
  view::Camera lead(const view::Camera& camera, CameraMode mode, std::optional<int> pup,
                    const LitterView& litter);

 private:
  std::optional<view::Camera> before_;  // looking out of a pup's eyes
};

}  // namespace pupflow::window
