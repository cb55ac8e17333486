// The simulation on a thread of its own: commands in, snapshots out.
#pragma once

#include <array>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "app/window/pacer.h"
#include "app/window/session.h"

namespace pupflow::window {

/// Steps a litter at its speed. The window asks for a snapshot when it is ready to draw one; the
/// runner copies the state then and only then, so neither ever waits for the other. At rest the
/// thread sleeps.
class Runner {
 public:
  struct Options {
    Params params;
    bool playing = true;
    int threads = 1;               // that share a step
    bool hashed = false;           // snapshots carry the hash
    std::function<void()> notify;  // called on the runner's thread after a snapshot is out
  };

  /// Throws InvalidParams.
  explicit Runner(Options options);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Queues a command; it is carried out before the next step. An edit that follows another one
  /// still in the queue takes its place.
  void send(Command command);

  /// Asks for one snapshot as soon as something has changed since the last.
  void request();

  /// Takes the snapshot asked for, when it is there: true, and `snapshot()` is the new one.
  /// Rethrows what ended the runner's thread. `take` and `snapshot` are for one thread only.
  bool take();
  const Snapshot& snapshot() const { return *front_; }

 private:
  void loop();
  bool idle_until_work(std::vector<Command>& commands);
  void obey(std::vector<Command>& commands);
  bool resting() const { return !session_.hurried() && !session_.running(); }
  void step(double now);
  void measure(double now);
  void publish();

  Options options_;

  // Touched by the runner's thread only.
  Session session_;
  Pacer pacer_;
  double measured_from_ = 0, stepping_ = 0;
  double steps_per_second_ = 0, microseconds_per_step_ = 0;
  int measured_steps_ = 0;

  // Shared, under the mutex.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Command> queue_;
  bool requested_ = false, fresh_ = false, stop_ = false;
  std::exception_ptr failure_;

  // Three buffers: the runner fills back_, the window reads front_, and they meet in middle_.
  std::array<Snapshot, 3> buffers_;
  Snapshot* back_ = &buffers_[0];
  Snapshot* middle_ = &buffers_[1];
  Snapshot* front_ = &buffers_[2];

  std::thread thread_;  // last: starts when all else is there
};

}  // namespace pupflow::window
