// What is painted over a scene: marks and their legend, a scale bar, a caption. The same for
// pictures and for the window.
#pragma once

#include <vector>

#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/view/flat.h"
#include "app/view/marks.h"
#include "pupflow/view.h"

namespace pupflow::pictures {

/// Scenes of fewer pixels from top to bottom have no words in them.
constexpr int kLeastForWords = 160;

/// A scene, and how words are set over it.
struct Annotated {
  const LitterView& litter;
  const view::Camera& camera;
  const view::Projection& projection;
  double width, height;  // pixels
  double text_size;      // em
  view::Rgb ink;
  const view::TextWidth& width_of;
};

/// `marks` over that scene, and around them what words there is room for: their legend, the scale
/// bar and, where the look asks for one, the caption. `mark_scale` is that of view::flatten.
std::vector<view::Flat> annotations(const view::Marks& marks, double mark_scale, const Look& look,
                                    const Annotated& scene);

/// Adds a scale bar, one square of the floor's grid long where the camera's target is, in the lower
/// right corner of a scene of that size, with text of that size. Returns how far it reaches from the
/// right; 0 where there is no room for it.
double add_scale_bar(std::vector<view::Flat>& flats, double width, double height,
                     const view::Camera& camera, double text_size, view::Rgb ink);

/// The pups' centres.
std::vector<Eigen::Vector3d> centres_of(const LitterView& litter);

}  // namespace pupflow::pictures
