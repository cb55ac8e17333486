#include "app/window/session/session.h"

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace pupflow::window {
namespace {

std::shared_ptr<const Snapshot> shared(std::optional<Snapshot> snapshot) {
  return snapshot ? std::make_shared<const Snapshot>(std::move(*snapshot)) : nullptr;
}

/// Whether the command has to do with the step that the litter is at.
bool waits(const Command& command) {
  return std::visit(
      [](const auto& asked) {
        using Asked = std::remove_cvref_t<decltype(asked)>;
        return !(std::is_same_v<Asked, GoTo> || std::is_same_v<Asked, Speed> ||
                 std::is_same_v<Asked, ColorBy> || std::is_same_v<Asked, Watch> ||
                 std::is_same_v<Asked, Suspend> || std::is_same_v<Asked, Hash>);
      },
      command);
}

/// Whether the centres of some pup are further apart than half a pup radius.
bool parted(const LitterView& a, const LitterView& b) {
  const double distance = a.params.pup_radius / 2;
  for (int pup = 0; pup < std::min(a.pups, b.pups); ++pup) {
    if ((a.positions.mean(pup) - b.positions.mean(pup)).norm() > distance) return true;
  }
  return false;
}

}  // namespace

Session::Session(const Params& params, bool playing, int threads, std::optional<Snapshot> from)
    : first_(params, shared(std::move(from)), threads, pup_fields().front().parts),
      threads_(threads),
      playing_(playing) {
  first_.keep_within(kKeyframeBytes);
}

void Session::apply(const Command& command) {
  changed_ = true;
  const bool goes = std::holds_alternative<GoTo>(command);
  if (waits(command) ? seeking() || !waiting_.empty() : goes && !waiting_.empty()) {
    if (goes && std::holds_alternative<GoTo>(waiting_.back())) waiting_.pop_back();
    waiting_.push_back(command);
  } else {
    carry_out(command);
  }
}

void Session::carry_out(const Command& command) {
  std::visit(
      [&](const auto& asked) {
        using Asked = std::remove_cvref_t<decltype(asked)>;
        if constexpr (std::is_same_v<Asked, PlayPause>) {
          playing_ = !playing_ && ok();
          pending_ = 0;
        } else if constexpr (std::is_same_v<Asked, Advance>) {
          playing_ = false;
          if (ok()) pending_ += asked.steps;
        } else if constexpr (std::is_same_v<Asked, Speed>) {
          speed_ = asked.factor;
        } else if constexpr (std::is_same_v<Asked, Edit>) {
          edit(asked);
        } else if constexpr (std::is_same_v<Asked, Restart>) {
          restart();
        } else if constexpr (std::is_same_v<Asked, Open>) {
          open(asked);
        } else if constexpr (std::is_same_v<Asked, ColorBy>) {
          color_by_ = asked.field;
          record();
        } else if constexpr (std::is_same_v<Asked, Watch>) {
          watch_ = asked;
          record();
        } else if constexpr (std::is_same_v<Asked, Suspend>) {
          suspended_ = asked.on;
        } else if constexpr (std::is_same_v<Asked, GoTo>) {
          stop();
          gone_to_ = asked.number;
          go_to(std::clamp(asked.step, first_.run().first(), first_.run().last));
        } else if constexpr (std::is_same_v<Asked, SwapFuture>) {
          swap_futures();
        } else if constexpr (std::is_same_v<Asked, RampTo>) {
          ramp(asked);
        } else if constexpr (std::is_same_v<Asked, Undo>) {
          undo();
        } else if constexpr (std::is_same_v<Asked, Redo>) {
          redo();
        } else if constexpr (std::is_same_v<Asked, Pull>) {
          pull(asked);
        } else if constexpr (std::is_same_v<Asked, Compare>) {
          compare(asked);
        } else {
          static_assert(std::is_same_v<Asked, Hash>);
          hash_wanted_ = true;
        }
      },
      command);
}

/// The former run is gone, with all that could be gone back to.
void Session::open(const Open& asked) {
  rejected_.clear();
  try {
    Litter opened(asked.params, shared(asked.from), threads_, PartSet{});
    stop();
    first_ = std::move(opened);
  } catch (const std::bad_alloc&) {
    rejected_ = "not enough memory for that litter; the one before is still there";
  } catch (const std::invalid_argument& problem) {
    rejected_ = problem.what();
  }
  if (!rejected_.empty()) {
    ++refusals_;
    return;
  }
  second_.reset();
  differing_.clear();
  log_ = {};
  first_.keep_within(kKeyframeBytes);
  record();
}

/// Has the steps to come record what is shown; at rest the last one is taken again for it.
void Session::record() {
  const PartSet wanted = color_by_->parts | watch_.parts;
  for (Litter* litter : litters()) {
    litter->record(wanted);
    if (rests() && litter->ok() && !litter->recorded()) litter->seek_anew();
  }
}

std::vector<Litter*> Session::litters() {
  std::vector<Litter*> all{&first_};
  if (second_) all.push_back(&*second_);
  return all;
}

void Session::stop() {
  playing_ = interrupted_ = false;
  pending_ = 0;
  let_go();
}

void Session::go_to(std::int64_t step) {
  for (Litter* litter : litters()) litter->seek(step);
  if (!seeking()) arrived();
}

/// What waited for the step is carried out.
void Session::arrived() {
  changed_ = true;
  while (!waiting_.empty() && !seeking()) {
    const Command next = std::move(waiting_.front());
    waiting_.pop_front();
    carry_out(next);
  }
}

void Session::swap_futures() {
  rejected_.clear();
  if (!first_.other()) return;
  if (second_ && !second_->other()) return compare_other_future();
  stop();
  for (Litter* litter : litters()) litter->swap();
  if (second_) go_to(first_.run().last);  // the former runs may have ended at different steps
}

void Session::step() {
  if (seeking()) {
    for (Litter* litter : litters()) {
      if (litter->seeking()) litter->step();
    }
    see_parting();
    if (!seeking()) arrived();
    return;
  }
  changed_ = true;
  if (pending_ > 0) --pending_;
  hold();
  for (Litter* litter : litters()) litter->step();
  see_parting();
  if (ok()) return;
  interrupted_ = interrupted_ || playing_;
  playing_ = false;
  pending_ = 0;
}

/// Remembers where the two litters were first seen apart.
void Session::see_parting() {
  if (!second_ || first_.run().diverged_at || first_.at() != second_->at()) return;
  if (parted(first_.simulation(), second_->simulation())) first_.run().diverged_at = first_.at();
}

void Session::fill(LiveState& state) {
  changed_ = false;
  fill_litter(first_, state);
  if (second_) {
    if (!state.second) state.second.emplace();
    fill_litter(*second_, *state.second);
  } else {
    state.second.reset();
  }
  const Run& run = first_.run();
  state.diverged_at = second_ ? run.diverged_at : std::nullopt;
  Timeline& timeline = state.timeline;
  timeline.first = run.first();
  timeline.last = run.last;
  timeline.marks.assign(run.marks.begin(), run.marks.end());
  timeline.parted_at.reset();
  if (first_.other()) timeline.parted_at = first_.parted_at();
  timeline.other_last = first_.other() ? first_.other()->last : 0;
  timeline.can_undo = log_.can_undo();
  timeline.can_redo = log_.can_redo();
  state.playing = playing_;
  state.speed = speed_;
  state.rejected = rejected_;
  state.refusals = refusals_;
  state.gone_to = gone_to_;
  state.hash.reset();
  const bool wanted = std::exchange(hash_wanted_, false);
  if (wanted || rests()) state.hash = first_.simulation().hash();
}

void Session::fill_litter(const Litter& litter, LitterState& state) const {
  state.litter.take(litter.simulation(), color_by_->velocities || watch_.velocities);
  state.observables = litter.observables();
  state.history = litter.run().history;
  state.status = litter.simulation().status();
  state.warnings.clear();
  for (const Warning& warning : litter.run().warnings) {
    if (warning.step <= litter.at()) state.warnings.push_back(warning);
  }
}

}  // namespace pupflow::window
