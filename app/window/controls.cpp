#include "app/window/controls.h"

#include <algorithm>
#include <limits>

namespace pupflow::window {

void Controls::propose(const Params& candidate) {
  const std::vector<Problem> problems = check(candidate);
  problem = problems.empty() ? std::string{} : problems.front().message;
  if (!problems.empty() || candidate == params) return;
  params = candidate;
  commands.push_back(Edit{params});
}

void Controls::color_by(const LitterField& field) {
  look.scale = view::ColorScale(field);
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
