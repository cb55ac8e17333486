// Pulls of a session: how the spring of the mouse becomes forces in the recipe.
#include <algorithm>
#include <cmath>

#include "app/window/session/pull.h"
#include "app/window/session/session.h"

namespace pupflow::window {

void Session::pull(const Pull& asked) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!asked.pup || *asked.pup < 0 || *asked.pup >= params().pups ||
      !std::all_of(asked.target.begin(), asked.target.end(), finite)) {
    pull_.reset();
    return;
  }
  pull_marked_ = pull_marked_ && pull_ && pull_->pup == asked.pup;
  pull_ = asked;
}

/// Nobody is pulled any more, and the litters are at another step.
void Session::let_go() {
  pull_.reset();
  held_until_ = 0;
  pull_marked_ = false;
}

/// Has the force of the spring act for some steps to come.
void Session::hold() {
  if (!pull_ || first_.at() < held_until_) return;
  if (first_.run().recipe.schedule.changes().size() >= kMostPulls) {
    rejected_ = "the recipe of this run holds all the pulls that it can; restart to pull again";
    pull_.reset();
    return;
  }
  held_until_ = first_.at() + pull_steps(params().dt);
  for (Litter* litter : litters()) {
    if (*pull_->pup >= litter->params().pups) {
      litter->set({});  // in the past another future begins for both
      continue;
    }
    Change change{.step = litter->at(),
                  .until = held_until_,
                  .settings = {},
                  .pup = pull_->pup,
                  .action = {}};
    change.action.force = pull_force(litter->simulation(), *pull_->pup, pull_->target);
    if (change.action.acts()) litter->act(change);
  }
  mark_pull();
}

void Session::mark_pull() {
  std::vector<Run::Mark>& marks = first_.run().marks;
  const auto last = std::find_if(marks.rbegin(), marks.rend(), [](const Run::Mark& mark) {
    return mark.kind == Timeline::Kind::pull;
  });
  if (pull_marked_ && last != marks.rend()) {
    last->until = held_until_;
  } else {
    first_.run().add({{first_.at(), held_until_, Timeline::Kind::pull,
                       "pup " + std::to_string(*pull_->pup) + " pulled"}});
  }
  pull_marked_ = true;
}

}  // namespace pupflow::window
