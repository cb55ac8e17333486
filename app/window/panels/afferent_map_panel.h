// What each afferent of a pup feels, on flat maps of its skin.
#pragma once

#include <optional>
#include <vector>

#include "app/view/afferent_map.h"
#include "app/view/color_scale.h"
#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws into the current Dear ImGui window a list of the afferents' fields, the skin of a pup as a
/// disc seen ahead and as a cross, and the legend of the colors. The mouse on a cell says what it is.
class AfferentMapPanel {
 public:
  void draw(const PanelInput& in, int pup);

  const LitterField& field() const { return *field_; }

 private:
  struct Look {                  // of one frame
    std::vector<double> values;  // of the afferents
    std::vector<ImU32> colors;
    std::vector<bool> left;
    int ahead;  // the afferent that looks along the heading
    view::ColorScale scale;
  };

  Look look_at(const PanelInput& in, int pup) const;
  void draw_fields(const PanelInput& in);
  void draw_disc(const PanelInput& in, int pup, const Look& look);
  void draw_cross(const PanelInput& in, int pup, const Look& look);
  void draw_legend(const PanelInput& in, const Look& look) const;
  void point_at(const PanelInput& in, int pup, const Look& look, int afferent);

  const LitterField* field_ = find_field("temperature");
  std::optional<view::HeadingDisc> disc_;
  std::optional<view::SkinCross> cross_;
  int hovered_ = -1;  // the afferent under the mouse, in this frame or the last one
};

}  // namespace pupflow::window
