#include "app/window/session/runner.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace pupflow::window {
namespace {

constexpr double kMeasureOver = 0.5;  // seconds over which the speed is measured

// Seconds between two snapshots while the litter steps as fast as it can. A frame takes time from
// the steps, where the processor draws, and nobody could follow more of them.
constexpr double kFastInterval = 1.0 / 30;

using Clock = std::chrono::steady_clock;

double seconds() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

Clock::time_point time_point(double seconds_since_epoch) {
  return Clock::time_point(std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(seconds_since_epoch)));
}

/// Whether `command` leaves nothing to do of the one `before` it. An edit takes over when the drag
/// of the slider began.
bool replaces(Command& command, const Command& before) {
  if (command.index() != before.index()) return false;
  if (Edit* const edit = std::get_if<Edit>(&command)) {
    if (!edit->continues) return false;
    edit->before = std::get<Edit>(before).before;
    edit->continues = std::get<Edit>(before).continues;
    return true;
  }
  return std::holds_alternative<GoTo>(command) || std::holds_alternative<Pull>(command);
}

}  // namespace

Runner::Runner(Options options)
    : options_(std::move(options)),
      session_(options_.params, options_.playing, options_.threads, options_.from),
      thread_([this] { loop(); }) {}

Runner::~Runner() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Runner::send(Command command) {
  {
    const std::lock_guard lock(mutex_);
    if (!queue_.empty() && replaces(command, queue_.back())) queue_.pop_back();
    queue_.push_back(std::move(command));
  }
  changed_.notify_one();
}

void Runner::request() {
  {
    const std::lock_guard lock(mutex_);
    requested_ = true;
  }
  changed_.notify_one();
}

bool Runner::take() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (!fresh_) return false;
  fresh_ = false;
  std::swap(front_, middle_);
  return true;
}

bool Runner::commands_to_come() {
  const std::lock_guard lock(mutex_);
  return !queue_.empty() || busy_since_ > 0;
}

double Runner::busy_for() const {
  const double since = busy_since_;
  return since > 0 ? seconds() - since : 0;
}

void Runner::loop() {
  try {
    std::vector<Command> commands;
    while (wait_for_work(commands)) {
      if (!commands.empty()) apply(commands);
      const double now = seconds();
      if (session_.hurried() || (session_.running() && pacer_.due(now))) step(now);
      measure(seconds());
      publish();
      busy_since_ = 0;
    }
  } catch (...) {
    {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
    if (options_.notify) options_.notify();
  }
}

/// Sleeps until there is a command, a due step or a snapshot to hand out, and takes the commands.
/// Returns false when the thread must end.
bool Runner::wait_for_work(std::vector<Command>& commands) {
  std::unique_lock lock(mutex_);
  const auto called = [&] {
    return stop_ || !queue_.empty() || (requested_ && session_.changed());
  };
  if (session_.hurried()) {
    // a requested step is due at once
  } else if (session_.running()) {
    if (!pacer_.due(seconds())) changed_.wait_until(lock, time_point(pacer_.next()), called);
  } else {
    changed_.wait(lock, called);
  }
  std::swap(commands, queue_);
  busy_since_ = seconds();
  return !stop_;
}

void Runner::apply(std::vector<Command>& commands) {
  const bool rested = resting();
  for (const Command& command : commands) session_.apply(command);
  commands.clear();
  commanded_ = true;
  const double now = seconds();
  pacer_.reschedule(now, step_interval(session_.params().dt, session_.speed()));
  if (rested) measured_from_ = now;
}

void Runner::step(double now) {
  pacer_.stepped(now, step_interval(session_.params().dt, session_.speed()));
  session_.step();
  stepping_ += seconds() - now;
  ++measured_steps_;
}

void Runner::measure(double now) {
  const double elapsed = now - measured_from_;
  if (!resting() && elapsed < kMeasureOver) return;
  if (measured_steps_ > 0) microseconds_per_step_ = 1e6 * stepping_ / measured_steps_;
  steps_per_second_ = resting() ? 0 : measured_steps_ / elapsed;
  measured_from_ = now;
  stepping_ = 0;
  measured_steps_ = 0;
}

void Runner::publish() {
  if (!session_.changed()) return;
  const double now = seconds();
  const bool fast = session_.running() && std::isinf(session_.speed());
  if (fast && !commanded_ && now < published_ + kFastInterval) return;
  {
    const std::lock_guard lock(mutex_);
    if (!requested_ && !(fresh_ && commanded_)) return;
    requested_ = commanded_ = false;
  }
  published_ = now;
  session_.fill(*back_);
  back_->steps_per_second = steps_per_second_;
  back_->microseconds_per_step = microseconds_per_step_;
  bool told = false;  // of one that is not taken yet
  {
    const std::lock_guard lock(mutex_);
    std::swap(back_, middle_);
    told = std::exchange(fresh_, true);
  }
  if (options_.notify && !told) options_.notify();
}

}  // namespace pupflow::window
