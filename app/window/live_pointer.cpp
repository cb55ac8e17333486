// What the mouse does to pups in the live window: selects them, has the camera follow, pulls them.
#include "app/view/pick.h"
#include "app/window/live_window.h"

namespace pupflow::window {

/// The line of sight under the mouse.
view::Ray LiveWindow::sight_at_mouse(const Area& arena) const {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto share = [](float place, float corner, float size) {
    return static_cast<double>((place - corner) / size);
  };
  return view::sight(arena_.camera(), static_cast<double>(arena.size.x / arena.size.y),
                     share(mouse.x, arena.corner.x, arena.size.x),
                     share(mouse.y, arena.corner.y, arena.size.y));
}

/// Whether the mouse is in the second arena, or still pulls there.
bool LiveWindow::at_second(const ArenaAreas& arenas) const {
  if (!arenas.second) return false;
  return pulled_ ? pulled_->second : arenas.second->holds(ImGui::GetIO().MousePos);
}

/// A click without a drag selects, a double click follows, Ctrl + drag pulls: the pup of that number
/// in both litters.
void LiveWindow::point_at_pups(const ArenaAreas& arenas) {
  const ImGuiIO& io = ImGui::GetIO();
  const float still = kStillPixels * gui_->scale();
  const bool second = at_second(arenas);
  const Area& arena = second ? *arenas.second : arenas.first;
  const LiveState& state = runner_.snapshot();
  const auto under_mouse = [&] {
    return view::pick(second ? state.second->view() : state.view(), sight_at_mouse(arena));
  };
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    pressed_arena_ = !io.WantCaptureMouse && arena.holds(io.MousePos) && !io.KeyShift;
    if (!pressed_arena_) return;
    if (io.KeyCtrl) {
      pressed_arena_ = false;
      if (const auto pup = under_mouse()) begin_pull(*pup, second);
    } else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      pressed_arena_ = false;
      if (const auto pup = under_mouse()) controls_.show(*pup);
    }
    schedule_.panels_changed();
  } else if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    if (pulled_) end_pull();
    if (!pressed_arena_) return;
    pressed_arena_ = false;
    if (io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > still * still) return;
    controls_.select(under_mouse());
    schedule_.panels_changed();
  } else if (pulled_ && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    pull(arena);
  }
}

/// The pup stays as far from the eye as it was.
void LiveWindow::begin_pull(int pup, bool second) {
  const LiveState& state = runner_.snapshot();
  const auto middle = middle_of(second ? state.second->view() : state.view(), pup);
  if (!middle) return;
  controls_.select(pup);
  pulled_ = Pulled{pup, second, *middle, *middle};
}

void LiveWindow::pull(const Area& arena) {
  const Eigen::Vector3d across = arena_.camera().backward();
  const view::Ray ray = sight_at_mouse(arena);
  const double slope = ray.along.dot(across);
  if (slope == 0) return;
  const Eigen::Vector3d target =
      ray.from + (pulled_->middle - ray.from).dot(across) / slope * ray.along;
  pulled_->target = target;
  controls_.commands.push_back(Pull{pulled_->pup, {target.x(), target.y(), target.z()}});
}

void LiveWindow::end_pull() {
  controls_.commands.push_back(Pull{});
  pulled_.reset();
}

/// The camera goes with the selected pup. The selection ends with the litter that it was in.
void LiveWindow::lead_camera(double now) {
  const LitterView litter = runner_.snapshot().view();
  if (controls_.selected && *controls_.selected >= litter.pups) controls_.select({});
  const view::Camera before = arena_.camera();
  const view::Camera led = guide_.lead(before, controls_.camera_mode, controls_.selected, litter);
  arena_.look_from(led);
  if (led != before && !schedule_.fresh()) schedule_.view_moved(now);
  events_.selected(controls_.selected, controls_.camera_mode);
}

/// Of what the mouse does to pups. Nobody sees a mark on himself.
view::Marks LiveWindow::marks_of(const LitterView& litter, const view::Camera& camera) const {
  view::Marks marks;
  if (pulled_ && pulled_->pup < litter.pups) {
    mark_pull(litter, pulled_->pup, pulled_->target, marks);
  }
  const std::optional<int> selected = controls_.selected;
  if (selected && *selected < litter.pups && controls_.camera_mode != CameraMode::eye) {
    mark_pup(litter, *selected, camera, marks);
  }
  return marks;
}

void LiveWindow::perform_on_pup(Action action) {
  const int pups = runner_.snapshot().view().pups;
  const auto toggle = [&](CameraMode mode) {
    if (!controls_.selected) {
      show("Select a pup first: click on it, or press Tab.");
      return;
    }
    controls_.camera_mode = controls_.camera_mode == mode ? CameraMode::free : mode;
  };
  if (pups == 0) return;
  if (action == Action::next_pup) controls_.selected = next_pup(controls_.selected, pups, 1);
  if (action == Action::previous_pup) controls_.selected = next_pup(controls_.selected, pups, -1);
  if (action == Action::follow_pup) toggle(CameraMode::follow);
  if (action == Action::pups_eye) toggle(CameraMode::eye);
}

}  // namespace pupflow::window
