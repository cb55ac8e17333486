#include "app/window/session/edit_log.h"

#include <algorithm>
#include <utility>

#include "pupflow/parameters.h"

namespace pupflow::window {
namespace {

constexpr std::size_t kMostNamed = 3;

bool same_parameters(const Deed& a, const Deed& b) {
  return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                    [](const Edited& x, const Edited& y) { return x.parameter == y.parameter; });
}

}  // namespace

std::string text_of(const std::vector<Edited>& values) {
  std::string text;
  for (std::size_t i = 0; i < std::min(values.size(), kMostNamed); ++i) {
    const Parameter& parameter = parameters()[values[i].parameter];
    if (i > 0) text += ", ";
    text += std::string(parameter.symbol) + ' ' + format_value(parameter, values[i].from) +
            " \u2192 " + format_value(parameter, values[i].to);
  }
  if (values.size() > kMostNamed) {
    text += " and " + std::to_string(values.size() - kMostNamed) + " more";
  }
  return text;
}

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
