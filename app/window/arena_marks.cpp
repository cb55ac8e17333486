#include "app/window/arena_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/pictures/annotations.h"
#include "app/window/text_line.h"

namespace pupflow::window {
namespace {

constexpr double kIdText = 17;  // of the smallest labels of marks

class Painter {
 public:
  Painter(ImDrawList& list, ImFont& font, const Area& area)
      : list_(list), font_(font), corner_(area.corner) {}

  void operator()(const view::FlatLine& flat) {
    const ImU32 ink = packed(flat.ink.color, flat.ink.opacity);
    const auto width = static_cast<float>(flat.width);
    if ((flat.to - flat.from).norm() < 1e-6) {
      list_.AddCircleFilled(at(flat.from), width / 2, ink);
    } else {
      list_.AddLine(at(flat.from), at(flat.to), ink, width);
    }
  }

  void operator()(const view::FlatFill& flat) {
    std::vector<ImVec2> corners;
    double twice_area = 0;
    for (std::size_t i = 0; i < flat.corners.size(); ++i) {
      const Eigen::Vector2d &a = flat.corners[i], &b = flat.corners[(i + 1) % flat.corners.size()];
      twice_area += a.x() * b.y() - a.y() * b.x();
      corners.push_back(at(a));
    }
    if (twice_area < 0) std::ranges::reverse(corners);  // clockwise on screen, for soft edges
    list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()),
                              packed(flat.ink.color, flat.ink.opacity));
  }

  void operator()(const view::FlatText& flat) {
    const double x = aligned(font_, corner_.x + flat.at.x(), flat.text, flat.size, flat.align);
    const double y = static_cast<double>(corner_.y) + flat.at.y();
    const double away = view::halo_width(flat.size);
    for (int i = 0; flat.halo && i < 8; ++i) {
      const double angle = i * std::numbers::pi / 4;
      draw_line(list_, font_, x + away * std::cos(angle), y + away * std::sin(angle), flat.text,
                flat.size, IM_COL32_WHITE);
    }
    draw_line(list_, font_, x, y, flat.text, flat.size, packed(flat.color));
  }

 private:
  ImVec2 at(const Eigen::Vector2d& place) const {
    return {corner_.x + static_cast<float>(place.x()), corner_.y + static_cast<float>(place.y())};
  }

  ImDrawList& list_;
  ImFont& font_;
  ImVec2 corner_;
};

}  // namespace

void paint_flats(ImDrawList& list, ImFont& font, std::span<const view::Flat> flats,
                 const Area& area) {
  list.PushClipRect(area.corner, {area.corner.x + area.size.x, area.corner.y + area.size.y}, true);
  Painter painter(list, font, area);
  for (const view::Flat& flat : flats) std::visit(painter, flat);
  list.PopClipRect();
}

double mark_scale(double height, double em) {
  return std::max(height / view::kMarkRows, em / kIdText);
}

void paint_marks(ImDrawList& list, const view::Marks& marks, const view::Camera& camera,
                 const Area& area, std::span<const view::Ball> bodies) {
  std::vector<view::Flat> flats;
  const auto em = static_cast<double>(ImGui::GetFontSize());
  view::flatten(marks, projection_on(camera, area, bodies),
                mark_scale(static_cast<double>(area.size.y), em), flats);
  paint_flats(list, *ImGui::GetFont(), flats, area);
}

view::Projection projection_on(const view::Camera& camera, const Area& area,
                               std::span<const view::Ball> bodies) {
  const auto whole = [](float size) { return std::max(1, static_cast<int>(std::lround(size))); };
  return {camera, {}, whole(area.size.x), whole(area.size.y), bodies};
}

void ArenaMarks::watch(const LitterView& litter, const pictures::Look& look) {
  if (!look.overlays.has("trails")) {
    trails_ = view::Trails();
    return;
  }
  if (trails_.seconds() != look.trail) {
    trails_ = view::Trails(look.trail);
    marked_.reset();
  }
  trails_.add(litter);
}

void ArenaMarks::paint(ImDrawList& list, const Scene& scene, bool fresh, const pictures::Look& look,
                       const view::Marks& more) {
  const auto em = static_cast<double>(ImGui::GetFontSize());
  const auto width = static_cast<double>(scene.area.size.x);
  const auto height = static_cast<double>(scene.area.size.y);
  watch(scene.litter, look);
  if (fresh || marked_ != look.overlays) {
    marks_.clear();
    if (!look.overlays.empty()) {
      look.overlays.draw({scene.litter, scene.scale, pictures::centres_of(scene.litter), trails_},
                         marks_);
    }
    marked_ = look.overlays;
  }
  const view::Projection projection = projection_on(scene.camera, scene.area, scene.bodies);
  ImFont& font = *ImGui::GetFont();
  const view::TextWidth text_width = [&](const view::TextLine& line, double size) {
    return width_of(font, line, size);
  };
  paint_marks(list, more, scene.camera, scene.area, scene.bodies);
  paint_flats(list, font,
              pictures::annotations(marks_, mark_scale(height, em), look,
                                    {.litter = scene.litter,
                                     .camera = scene.camera,
                                     .projection = projection,
                                     .width = width,
                                     .height = height,
                                     .text_size = em,
                                     .ink = {40, 40, 40},
                                     .width_of = text_width}),
              scene.area);
}

}  // namespace pupflow::window
