// Paints over the arena with Dear ImGui what pictures paint over theirs.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>

#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/view/flat.h"
#include "app/view/marks.h"
#include "app/view/overlay.h"
#include "app/window/panels/area.h"

namespace pupflow::window {

/// Paints `flats`, which are in window coordinates from the area's upper left corner; what would
/// reach out of the area is cut off there.
void paint_flats(ImDrawList& list, ImFont& font, std::span<const view::Flat> flats,
                 const Area& area);

/// What widths and sizes of marks are multiplied by in an arena of that height: their labels are
/// never smaller than the panels' text, whose size is `em`.
double mark_scale(double height, double em);

/// Paints `marks` over the arena that `camera` shows in `area`. Bodies hide what marks lie on the
/// floor. For the panels' typeface and text size.
void paint_marks(ImDrawList& list, const view::Marks& marks, const view::Camera& camera,
                 const Area& area, std::span<const view::Ball> bodies = {});

/// Where places of the arena are in `area`, from its upper left corner.
view::Projection projection_on(const view::Camera& camera, const Area& area,
                               std::span<const view::Ball> bodies = {});

/// The overlays, their legend, the scale bar and the caption over the arena.
class ArenaMarks {
 public:
  /// What the arena shows in `area`, whose colors are those of the fitted `scale`.
  struct Scene {
    const LitterView& litter;
    const view::ColorScale& scale;
    const view::Camera& camera;
    std::span<const view::Ball> bodies;
    const Area& area;
  };

  /// Paints what `look` asks for, and `more` beneath it, into `list`. `fresh`: the litter is another
  /// one than last time.
  void paint(ImDrawList& list, const Scene& scene, bool fresh, const pictures::Look& look,
             const view::Marks& more = {});

  /// Where the pups were; nothing while the look has no trails.
  const view::Trails& trails() const { return trails_; }

 private:
  void watch(const LitterView& litter, const pictures::Look& look);

  view::Trails trails_;
  view::Marks marks_;                       // of the overlays
  std::optional<view::OverlaySet> marked_;  // the overlays that they are of
};

}  // namespace pupflow::window
