#include "app/window/controls.h"

#include <algorithm>
#include <limits>

namespace pupflow::window {

void Controls::propose(const Params& candidate) {
  const std::vector<Problem> problems = check(candidate);
  problem = problems.empty() ? std::string{} : problems.front().message;
  if (!problems.empty() || candidate == params) return;
  commands.push_back(Edit{candidate, params});
  params = candidate;
}

void Controls::follow(const Params& in_force, const Schedule& schedule) {
  for (const Change& change : schedule.changes()) {
    for (const auto& [place, value] : change.settings) {
      const Parameter& parameter = parameters()[place];
      const double now = parameter.get(in_force);
      if (now != parameter.get(seen)) parameter.set(params, now);
    }
  }
  seen = in_force;
}

void Controls::color_by(const LitterField& field) {
  look.scale = view::ColorScale(field);
  look.scale.follow_data();
  commands.push_back(ColorBy{&field});
}

void Controls::set_speed(double factor) {
  speed = std::clamp(factor, kSlowest, kFastest);
  set_as_fast(false);
}

void Controls::set_as_fast(bool on) {
  as_fast = on;
  commands.push_back(Speed{on ? std::numeric_limits<double>::infinity() : speed});
}

}  // namespace pupflow::window
