// What changes the run of a session's litters.
#include <algorithm>
#include <memory>
#include <utility>

#include "app/window/session/session.h"

namespace pupflow::window {
namespace {

bool defines_the_litter(const Edited& value) {
  return parameters()[value.parameter].effect == Parameter::Effect::restart;
}

std::vector<Edited> reversed(const std::vector<Edited>& values, const Params& now) {
  std::vector<Edited> back;
  for (const Edited& value : values) {
    back.push_back({value.parameter, parameters()[value.parameter].get(now), value.from});
  }
  return back;
}

/// Why that ramp cannot be; empty when it can.
std::string problem_of(const RampTo& asked) {
  if (asked.parameter >= parameters().size()) return "there is no such parameter to ramp";
  const Parameter& parameter = parameters()[asked.parameter];
  const std::string name(parameter.name);
  if (parameter.effect != Parameter::Effect::next_step) {
    return name + " cannot change during a run, so it cannot be ramped";
  }
  if (parameter.kind != Parameter::Kind::real) {
    return name + " has no values between, so it cannot be ramped";
  }
  if (asked.steps < 1 || static_cast<double>(asked.steps) > kExactInteger / 4) {
    return "a ramp takes at least one step, and at most 2^51";
  }
  Problem problem;
  return check_value(parameter, asked.value, problem) ? std::string{} : problem.message;
}

std::vector<Change> ramp_of(const RampTo& asked, double from, std::int64_t at) {
  const auto part = [&](std::int64_t begin, double value) {
    return Change{.step = begin,
                  .until = begin + asked.steps,
                  .settings = {{asked.parameter, value}},
                  .pup = {},
                  .action = {}};
  };
  std::vector<Change> parts{part(at, asked.value)};
  if (asked.back) parts.push_back(part(at + asked.steps, from));
  return parts;
}

}  // namespace

/// A bad state cannot go on, so what changes the run is done at the last good step. Returns whether
/// it has to wait for that.
bool Session::back_from_bad(const Command& command) {
  if (ok()) return false;
  waiting_.push_front(command);
  go_to(second_ ? std::min(first_.run().last, second_->run().last) : first_.run().last);
  return true;
}

bool Session::differs(std::size_t parameter) const {
  return std::find(differing_.begin(), differing_.end(), parameter) != differing_.end();
}

/// What of `values` is for that litter: for the second one all but what makes it different.
std::vector<Setting> Session::settings_of(std::span<const Edited> values,
                                          const Litter& litter) const {
  std::vector<Setting> settings;
  for (const Edited& value : values) {
    if (&litter == &first_ || !differs(value.parameter)) {
      settings.push_back({value.parameter, value.to});
    }
  }
  return settings;
}

void Session::edit(const Edit& asked) {
  rejected_.clear();
  std::vector<Edited> values;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& parameter = parameters()[i];
    const double now = parameter.get(params()), wanted = parameter.get(asked.params);
    const bool meant = !asked.before || parameter.get(*asked.before) != wanted;
    if (meant && wanted != now) values.push_back({i, now, wanted});
  }
  if (values.empty()) return;
  const bool restarts = std::any_of(values.begin(), values.end(), defines_the_litter);
  if (!restarts && back_from_bad(asked)) return;
  const std::shared_ptr<const Snapshot> from = restarts ? first_.run().from : nullptr;
  if (!take(values)) {
    ++refusals_;
    return;
  }
  const bool joins = log_.add({values, {}, from}, asked.continues);
  if (!restarts) mark_edit(log_.last().values, joins);
}

/// Sets the values now, or begins a new litter with them. Returns whether that could be done.
bool Session::take(std::span<const Edited> values) {
  if (std::any_of(values.begin(), values.end(), defines_the_litter)) return restart_with(values);
  for (Litter* litter : litters()) {
    rejected_ = litter->set(settings_of(values, *litter));
    if (!rejected_.empty()) return false;
  }
  return true;
}

bool Session::restart_with(std::span<const Edited> values) {
  return begin_anew([&](const Litter& litter) {
    Params start = litter.start();
    for (const auto& [place, value] : settings_of(values, litter)) {
      parameters()[place].set(start, value);
    }
    return Begin{std::move(start), nullptr};
  });
}

void Session::restart() {
  rejected_.clear();
  begin_anew([&](const Litter& litter) {
    const std::shared_ptr<const Snapshot>& from = litter.run().from;
    return Begin{from ? from->params : litter.start(), from};
  });
}

/// Begins every litter as `begin` says, which is given the litter.
template <class BeginOf>
bool Session::begin_anew(const BeginOf& begin) {
  for (Litter* litter : litters()) {
    const Begin how = begin(*litter);
    rejected_ = litter->restart(how.recipe, how.from);
    if (rejected_.empty()) continue;
    if (litter == &first_) return false;
    rejected_ = "the second litter: " + rejected_;
    second_.reset();
    break;
  }
  let_go();
  pending_ = 0;
  playing_ = playing_ || interrupted_;
  interrupted_ = false;
  see_parting();
  return true;
}

void Session::ramp(const RampTo& asked) {
  rejected_ = problem_of(asked);
  if (!rejected_.empty() || back_from_bad(asked)) return;
  const double from = parameters()[asked.parameter].get(params());
  if (!begin_ramp(asked)) return;
  log_.add({{{asked.parameter, from, asked.value}}, Deed::Ramp{asked.steps, asked.back}, nullptr},
           false);
}

bool Session::begin_ramp(const RampTo& asked) {
  const std::vector<Edited> value{
      {asked.parameter, parameters()[asked.parameter].get(params()), asked.value}};
  for (Litter* litter : litters()) {
    if (litter != &first_ && differs(asked.parameter)) {
      rejected_ = litter->set({});
    } else {
      const double from = parameters()[asked.parameter].get(litter->params());
      rejected_ = litter->ramp(asked.parameter, ramp_of(asked, from, litter->at()));
    }
    if (!rejected_.empty()) return false;
  }
  const std::int64_t at = first_.at();
  first_.run().add({{at, at + asked.steps * (asked.back ? 2 : 1), Timeline::Kind::ramp,
                     text_of(value) + (asked.back ? " and back" : "")},
                    asked.parameter});
  return true;
}

void Session::undo() {
  rejected_.clear();
  if (!log_.can_undo()) return;
  const Deed& deed = log_.last();
  const std::vector<Edited> back = reversed(deed.values, params());
  const bool restarts = std::any_of(back.begin(), back.end(), defines_the_litter);
  if (!restarts && back_from_bad(Undo{})) return;
  bool done = false;
  if (deed.from) {
    done = begin_anew([&](const Litter&) { return Begin{deed.from->params, deed.from}; });
  } else {
    done = take(back);
  }
  if (!done) return;
  log_.undone();
  if (!restarts) mark_undone(back);
}

void Session::redo() {
  rejected_.clear();
  if (!log_.can_redo()) return;
  const Deed& deed = log_.next();
  const bool restarts = std::any_of(deed.values.begin(), deed.values.end(), defines_the_litter);
  if (!restarts && back_from_bad(Redo{})) return;
  if (deed.ramp) {
    const Edited& value = deed.values.front();
    if (!begin_ramp({value.parameter, value.to, deed.ramp->steps, deed.ramp->back})) return;
  } else {
    std::vector<Edited> again = reversed(deed.values, params());
    for (std::size_t i = 0; i < again.size(); ++i) again[i].to = deed.values[i].to;
    if (!take(again)) return;
    if (!restarts) mark_edit(again, false);
  }
  log_.redone();
}

/// `joins`: they are those of the edit that was marked last, and what became of it.
void Session::mark_edit(const std::vector<Edited>& values, bool joins) {
  std::vector<Run::Mark>& marks = first_.run().marks;
  if (joins && !marks.empty() && marks.back().kind == Timeline::Kind::edit) {
    const bool taken_back = std::all_of(values.begin(), values.end(),
                                        [](const Edited& value) { return value.from == value.to; });
    marks.back().text = text_of(values);
    if (taken_back && marks.back().step == first_.at()) marks.pop_back();
  } else {
    first_.run().add({{first_.at(), {}, Timeline::Kind::edit, text_of(values)}});
  }
}

/// An edit that is undone before the next step leaves no mark.
void Session::mark_undone(const std::vector<Edited>& values) {
  std::vector<Run::Mark>& marks = first_.run().marks;
  const bool just_made = !marks.empty() && marks.back().step == first_.at() &&
                         (marks.back().kind == Timeline::Kind::edit || marks.back().ramped);
  if (just_made) {
    marks.pop_back();
  } else {
    mark_edit(values, false);
  }
}

void Session::compare(const Compare& asked) {
  if (back_from_bad(asked)) return;
  rejected_.clear();
  second_.reset();
  differing_.clear();
  first_.forget_parting();
  first_.keep_within(kKeyframeBytes);
  if (!asked.with) return;
  std::vector<Setting> different;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const double value = parameters()[i].get(*asked.with);
    if (value != parameters()[i].get(params())) different.push_back({i, value});
  }
  put_beside(different, asked.from_now);
}

/// Has a second litter stand beside the first one. Returns whether it can.
bool Session::put_beside(std::span<const Setting> different, bool from_now) {
  std::optional<Litter> second;
  rejected_ = first_.beside(different, from_now, second);
  if (!second) return false;
  second_ = std::move(second);
  differing_.clear();
  for (const Setting& setting : different) differing_.push_back(setting.parameter);
  for (Litter* litter : litters()) litter->keep_within(kKeyframeBytes / 2);
  if (from_now) return true;
  const bool played = playing_;
  stop();
  playing_ = played;
  go_to(first_.run().first());
  see_parting();
  return true;
}

/// The other future was left before the comparison began: the second litter was not there. It begins
/// anew beside it, with what is different.
void Session::compare_other_future() {
  std::vector<Setting> different;
  for (const std::size_t place : differing_) {
    different.push_back({place, parameters()[place].get(second_->params())});
  }
  const std::int64_t here = first_.at();
  stop();
  first_.swap();
  first_.forget_parting();
  if (put_beside(different, false)) return;
  first_.swap();
  go_to(here);
}

}  // namespace pupflow::window
