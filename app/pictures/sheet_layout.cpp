#include "app/pictures/sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "app/view/flat.h"

namespace pupflow::pictures {

std::size_t panel_count(const SheetJob& job) {
  std::size_t count = 1;
  for (const Axis& axis : job.axes) count *= axis.values.size();
  return count;
}

SheetLayout::SheetLayout(const SheetJob& job, const std::vector<view::LegendEntry>& legend,
                         view::TextPainter& text)
    : panel_(job.panel), bar_(job.bar), own_bars_(job.bar && job.own_scales) {
  constexpr int kPanelsAcross = 4;
  const int panels = static_cast<int>(panel_count(job));
  if (job.axes.size() == 1) {
    rows_ = (panels + kPanelsAcross - 1) / kPanelsAcross;
    columns_ = (panels + rows_ - 1) / rows_;
  } else {
    columns_ = static_cast<int>(job.axes.front().values.size());
    rows_ = panels / columns_;
  }
  text_ = std::max(9.0, panel_ / 18.0);
  margin_ = static_cast<int>(std::lround(0.8 * text_));
  title_ = static_cast<int>(std::lround(1.7 * text_));
  bar_width_ = static_cast<int>(std::lround(text_));
  bar_style_.text_size = 0.72 * text_;
  bar_style_.ink = {40, 40, 40};
  bar_style_.celsius = job.look.celsius;
  bar_margins_ = view::color_bar_margins(job.look.scale, bar_style_);

  // Entries side by side as far as they fit.
  const double size = legend_text(), gap = 2 * size, top = margin_ + rows_ * cell_height();
  Eigen::Vector2d at(margin_, top);
  for (const view::LegendEntry& entry : legend) {
    const double wide = view::legend_width(
        [&](const view::TextLine& line, double em) { return text.width(line, em); }, {entry}, size);
    if (at.x() > margin_ && at.x() + wide > width() - margin_) {
      at = {margin_, at.y() + 1.6 * size};
    }
    legend_.push_back(at);
    at.x() += wide + gap;
  }
  if (!legend_.empty()) {
    legend_height_ = static_cast<int>(std::lround(at.y() - top + 1.6 * size)) + margin_ / 2;
  }
}

int SheetLayout::bar_strip() const {
  return bar_margins_.left + bar_width_ + bar_margins_.right;
}

int SheetLayout::cell_width() const {
  return panel_ + margin_ + (own_bars_ ? bar_strip() : 0);
}

view::Box SheetLayout::panel_box(int i) const {
  return {margin_ + i % columns_ * cell_width(), margin_ + i / columns_ * cell_height() + title_,
          panel_, panel_};
}

view::Box SheetLayout::bar_box(int i) const {
  const int inset = panel_ / 12;
  const view::Box panel = panel_box(i);
  if (own_bars_) {
    return {panel.x + panel_ + bar_margins_.left, panel.y + inset, bar_width_, panel_ - 2 * inset};
  }
  return {margin_ + columns_ * cell_width() + bar_margins_.left, margin_ + title_ + inset,
          bar_width_, (rows_ - 1) * cell_height() + panel_ - 2 * inset};
}

int SheetLayout::width() const {
  return margin_ + columns_ * cell_width() + (bar_ && !own_bars_ ? bar_strip() + margin_ : 0);
}

int SheetLayout::height() const {
  return margin_ + rows_ * cell_height() + legend_height_;
}

}  // namespace pupflow::pictures
