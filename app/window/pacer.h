// When the next step is due: model time against the clock on the wall.
#pragma once

namespace pupflow::window {

/// Keeps steps to a schedule. Owns no clock: every call is told the time in seconds. A short hiccup
/// is caught up; a machine that cannot keep up falls behind without piling up debt.
class Pacer {
 public:
  /// How late the schedule may run before what is missing is dropped.
  static constexpr double kMostDebt = 0.1;

  /// Something changed at `now`: the next step is due within one interval, and no debt is left.
  void reschedule(double now, double interval);

  /// Whether the next step is due.
  bool due(double now) const { return now >= next_; }

  /// When the next step is due, in the clock's seconds.
  double next() const { return next_; }

  /// A step was begun at `now`; the one after it is due `interval` seconds after this one was.
  void stepped(double now, double interval);

 private:
  double next_ = 0;
};

/// Seconds between two steps of `dt` model seconds at `speed` times real time; 0 when `speed` is
/// infinite (as fast as possible).
double step_interval(double dt, double speed);

}  // namespace pupflow::window
