// Paints over the arena with Dear ImGui what pictures paint over theirs.
#pragma once

#include <imgui.h>

#include <span>

#include "app/view/camera.h"
#include "app/view/flat.h"
#include "app/view/marks.h"
#include "app/window/panels/area.h"

namespace pupflow::window {

/// Paints `flats`, which are in window coordinates from the area's upper left corner; what would
/// reach out of the area is cut off there.
void paint_flats(ImDrawList& list, const ImFont& font, std::span<const view::Flat> flats,
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

}  // namespace pupflow::window
