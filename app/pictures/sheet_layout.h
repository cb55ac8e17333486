// Where the parts of a sheet are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/pictures/sheet_job.h"
#include "app/view/canvas.h"
#include "app/view/color_bar.h"
#include "app/view/marks.h"
#include "app/view/text.h"

namespace pupflow::pictures {

/// The panels of a sheet.
std::size_t panel_count(const SheetJob& job);

/// In pixels from the upper left corner. A bar of colors stands beside all panels, or beside each
/// where each has a scale of its own; entries of the overlays' legend stand below.
class SheetLayout {
 public:
  /// One axis goes on in the next row, as evenly as it can; of two the second goes down.
  SheetLayout(const SheetJob& job, const std::vector<view::LegendEntry>& legend,
              view::TextPainter& text);

  int width() const;
  int height() const;
  double text() const { return text_; }                                // em of titles
  double legend_text() const { return bar_style_.text_size; }          // of the legend
  const view::ColorBarStyle& bar_style() const { return bar_style_; }  // of the bars
  const view::ColorBarMargins& bar_margins() const { return bar_margins_; }
  view::Box panel_box(int i) const;

  /// The bar of panel i, or of all.
  view::Box bar_box(int i) const;

  /// The upper left corner of each entry of the legend.
  const std::vector<Eigen::Vector2d>& legend() const { return legend_; }

 private:
  int bar_strip() const;
  int cell_width() const;
  int cell_height() const { return title_ + panel_ + margin_; }

  int panel_, margin_, title_, columns_, rows_, bar_width_;
  bool bar_, own_bars_;
  double text_;
  view::ColorBarStyle bar_style_;
  view::ColorBarMargins bar_margins_;
  std::vector<Eigen::Vector2d> legend_;
  int legend_height_ = 0;
};

}  // namespace pupflow::pictures
