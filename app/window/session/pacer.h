// When the next step is due: model time against wall-clock time.
#pragma once

namespace pupflow::window {

/// Spaces steps evenly in time. Owns no clock: the time in seconds is an argument of every call.
/// Steps that a short delay held up are caught up. A machine that is too slow for the speed runs
/// slower, and no backlog of steps grows.
class Pacer {
 public:
  /// Seconds by which steps may be late; steps that are later are dropped.
  static constexpr double kLongestDelay = 0.1;

  /// The speed changed at `now`, or stepping starts: the next step is due within one interval, and
  /// steps that are late are dropped.
  void reschedule(double now, double interval);

  /// Whether the next step is due.
  bool due(double now) const { return now >= next_; }

  /// When the next step is due, in the clock's seconds.
  double next() const { return next_; }

  /// A step begins at `now`; the next one is due `interval` seconds after this one was due.
  void stepped(double now, double interval);

 private:
  double next_ = 0;
};

/// Seconds between two steps of `dt` model seconds at `speed` times real time; 0 when `speed` is
/// infinite (as fast as possible).
double step_interval(double dt, double speed);

}  // namespace pupflow::window
