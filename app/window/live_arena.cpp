// The arena of the live window: one litter, or two beside each other.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "app/window/live_window.h"
#include "app/window/session/parameter_text.h"

namespace pupflow::window {
namespace {

/// In the middle of `area`. Until it is drawn in a new size, the old one is cut off there.
Painter::Image placed(const gl::SharedPicture& picture, const PixelBox& area) {
  const int left = area.left + (area.width() - picture.width()) / 2;
  const int top = area.top + (area.height() - picture.height()) / 2;
  const PixelBox place = common(area, {left, top, left + picture.width(), top + picture.height()});
  return {&picture, place, place.left - left, place.top - top};
}

}  // namespace

/// Beside each other, or one above the other where that leaves more room.
LiveWindow::ArenaAreas LiveWindow::split_arena(const Area& arena, bool two) {
  split_ = !two ? Split::none : arena.size.x >= arena.size.y ? Split::beside : Split::above;
  if (!two) return {arena, {}};
  const ImVec2 corner = arena.corner;
  ImVec2 half = arena.size;
  if (split_ == Split::beside) {
    half.x = std::floor(half.x / 2);
    return {{corner, half}, Area{{corner.x + half.x, corner.y}, half}};
  }
  half.y = std::floor(half.y / 2);
  return {{corner, half}, Area{{corner.x, corner.y + half.y}, half}};
}

PixelBox LiveWindow::pixels_of(const Area& area) const {
  const auto pixels = [&](float length) {
    return static_cast<int>(std::lround(length * gui_->density()));
  };
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.handle(), &width, &height);
  PixelBox box{pixels(area.corner.x), pixels(area.corner.y), pixels(area.corner.x + area.size.x),
               pixels(area.corner.y + area.size.y)};
  box.right = std::max(std::min(box.right, width), box.left + 1);
  box.bottom = std::max(std::min(box.bottom, height), box.top + 1);
  return box;
}

/// Into stores of their own; and what is painted over them, into the panels' list.
LiveWindow::DrawnArenas LiveWindow::draw_arenas(const ArenaAreas& areas) {
  const LiveState& snapshot = runner_.snapshot();
  const int samples = schedule_.samples(controls_.look.samples());
  DrawnArenas drawn;
  const auto draw = [&](ArenaView& view, ArenaMarks& marks, const LitterView& litter,
                        const Area& area, bool fresh, bool& unmarked) {
    const PixelBox place = pixels_of(area);
    view.set_look(controls_.look);
    drawn.anew |= view.draw(litter, fresh, scale_, place.width(), place.height(), samples);
    unmarked |= fresh;
    if (view.shown().empty()) return;
    drawn.images.push_back(placed(view.shown(), place));
    const bool mark = unmarked && !view.drawing();  // with the bodies, not before them
    if (mark) unmarked = false;
    marks.paint(*ImGui::GetBackgroundDrawList(),
                {litter, scale_, view.drawn_camera(), view.bodies(), area}, mark, controls_.look,
                marks_of(litter, view.drawn_camera()));
  };
  draw(arena_, marks_, snapshot.view(), areas.first, schedule_.fresh(), unmarked_);
  if (!areas.second) {
    second_.reset();
    return drawn;
  }
  const bool begins = !second_;
  if (begins) {
    second_.reset(new SecondArena{{window_, controls_.look, glfwPostEmptyEvent}, {}, true});
  }
  second_->view.look_from(arena_.camera());
  draw(second_->view, second_->marks, snapshot.second->view(), *areas.second,
       schedule_.fresh() || begins, second_->unmarked);
  label_arenas(areas);
  return drawn;
}

/// Says in each what it differs by.
void LiveWindow::label_arenas(const ArenaAreas& areas) const {
  const LiveState& snapshot = runner_.snapshot();
  const Params& first = snapshot.view().params;
  const Params& second = snapshot.second->view().params;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const auto label = [&](const Area& area, const std::string& text) {  // beside the column of pups
    draw_rich_text(list, gui_->fonts(), {area.corner.x + em, area.corner.y + em}, kPaperInk, text);
  };
  label(areas.first, differing_values(first, second));
  label(*areas.second, differing_values(second, first));
  const ImVec2 from = areas.second->corner;
  const ImVec2 to = split_ == Split::beside ? ImVec2{from.x, from.y + areas.second->size.y}
                                            : ImVec2{from.x + areas.second->size.x, from.y};
  list.AddLine(from, to, ImGui::GetColorU32(ImGuiCol_Border));
}

void LiveWindow::paint(const DrawnArenas& drawn) {
  painter_.paint(*gui_, drawn.images, drawn.anew, gl::Palette{}.background);
  if (painter_.unsettled()) schedule_.panels_changed();
  if (!arena_.drawing()) drawn_params_ = runner_.snapshot().view().params;
  events_.shown(controls_.params, drawn_params_);
  events_.camera(arena_.camera());
  events_.frame(arena_.drawn_samples());
}

}  // namespace pupflow::window
