#include "app/window/controls.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pupflow::window {

void Controls::propose(const Params& candidate, bool continues) {
  const std::vector<Problem> problems = check(candidate);
  problem = problems.empty() ? std::string{} : problems.front().message;
  problem_at = problems.empty() ? std::string{} : problems.front().parameter;
  if (!problems.empty() || candidate == params) return;
  commands.push_back(Edit{candidate, params, continues});
  params = candidate;
}

void Controls::propose(const Parameter& parameter, double value, bool continues) {
  if (Problem found; !check_value(parameter, value, found)) {
    refuse(found.parameter, found.message);
    return;
  }
  Params candidate = params;
  parameter.set(candidate, value);
  propose(candidate, continues);
}

void Controls::refuse(std::string_view field, std::string reason) {
  problem = std::move(reason);
  problem_at = field;
}

void Controls::follow(const LiveState& state) {
  const Params& in_force = state.view().params;
  if (state.refusals != refusals) params = in_force;
  refusals = state.refusals;
  for (const Parameter& parameter : parameters()) {
    const double now = parameter.get(in_force);
    if (now != parameter.get(seen)) parameter.set(params, now);
  }
  seen = in_force;
  if (state.gone_to == goings) going_to.reset();
}

void Controls::go_to(std::int64_t step, const Timeline& timeline) {
  going_to = std::clamp(step, timeline.first, timeline.last);
  commands.push_back(GoTo{*going_to, ++goings});
}

std::int64_t Controls::shown_step(const LiveState& state) const {
  return going_to.value_or(state.view().step);
}

void Controls::select(std::optional<int> pup) {
  selected = pup;
  if (!pup) camera_mode = CameraMode::free;
}

void Controls::show(int pup) {
  select(pup);
  camera_mode = CameraMode::follow;
}

void Controls::watch() {
  const PartSet parts = look.overlays.parts() | inspected.parts;
  if (parts == watched.parts && inspected.velocities == watched.velocities) return;
  watched = {parts, inspected.velocities};
  commands.push_back(watched);
}

void Controls::color_by(const LitterField& field) {
  look.scale = view::ColorScale(field);
  look.scale.follow_data();
  commands.push_back(ColorBy{&field});
}

void Controls::set_speed(double factor) {
  speed = std::clamp(factor, kLeastSpeed, kGreatestSpeed);
  set_as_fast(false);
}

void Controls::faster() {
  set_speed(std::max(speed, std::min(2 * speed, kFastest)));
}

/// Below "as fast as possible" comes the speed before it.
void Controls::slower() {
  set_speed(as_fast ? speed : std::min(speed, std::max(speed / 2, kSlowest)));
}

void Controls::set_as_fast(bool on) {
  as_fast = on;
  commands.push_back(Speed{on ? std::numeric_limits<double>::infinity() : speed});
}

}  // namespace pupflow::window
