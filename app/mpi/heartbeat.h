// When a rank sends heartbeats, and when another rank is lost. Reads no clock.
#pragma once

#include <chrono>

namespace pupflow::mpi {

using Clock = std::chrono::steady_clock;

class HeartbeatTimer {
 public:
  struct Check {
    bool send;    // a heartbeat is due
    bool paused;  // this rank was paused since the last check (a stopped process, a slow disk)
  };

  /// A rank that sends no message for longer than `lost_after` is lost.
  HeartbeatTimer(Clock::duration lost_after, Clock::time_point now)
      : lost_after_(lost_after), checked_(now), sent_(now) {}

  /// To be called much more often than heartbeats are sent. After a pause the messages of other
  /// ranks may be here unread, so count their silence from `now` then.
  Check check(Clock::time_point now) {
    const Check check{now - sent_ >= lost_after_ / 8, now - checked_ > lost_after_ / 4};
    checked_ = now;
    if (check.send) sent_ = now;
    return check;
  }

  /// Whether a rank is lost whose last message came at `heard`.
  bool is_lost(Clock::time_point heard, Clock::time_point now) const {
    return now - heard > lost_after_;
  }

 private:
  Clock::duration lost_after_;
  Clock::time_point checked_, sent_;
};

}  // namespace pupflow::mpi
