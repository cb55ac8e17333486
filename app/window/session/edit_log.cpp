#include "app/window/session/edit_log.h"

#include <algorithm>
#include <utility>

namespace pupflow::window {
namespace {

bool same_parameters(const Deed& a, const Deed& b) {
  return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                    [](const Edited& x, const Edited& y) { return x.parameter == y.parameter; });
}

}  // namespace

bool EditLog::add(Deed deed, bool continues) {
  undone_.clear();
  const bool joins = continues && can_undo() && !done_.back().ramp && !deed.ramp &&
                     same_parameters(done_.back(), deed);
  if (joins) {
    for (std::size_t i = 0; i < deed.values.size(); ++i) {
      done_.back().values[i].to = deed.values[i].to;
    }
    return true;
  }
  if (done_.size() == kLongest) done_.pop_front();
  done_.push_back(std::move(deed));
  return false;
}

void EditLog::undone() {
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
}

void EditLog::redone() {
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
}

}  // namespace pupflow::window
