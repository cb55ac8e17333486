// The simulation on a thread of its own: commands in, snapshots out.
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "app/window/session/pacer.h"
#include "app/window/session/session.h"

namespace pupflow::window {

/// Steps a litter at its speed. The window asks for a snapshot when it can draw one, and the runner
/// copies the state only then. Neither waits for the other. The thread sleeps while no step is due
/// and no snapshot is to be handed out.
class Runner {
 public:
  struct Options {
    Params params;
    std::optional<Snapshot> from = {};  // a litter of that recipe to begin with; none: a new one
    bool playing = true;
    int threads = 1;               // for the loops of a step
    std::function<void()> notify;  // called on the runner's thread when a snapshot is ready
  };

  /// Throws InvalidParams.
  explicit Runner(Options options);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Queues a command; it is applied before the next step. A drag that goes on replaces what it last
  /// asked for, as long as that is the last in the queue.
  void send(Command command);

  /// Asks for one snapshot. It is made as soon as something has changed since the last one. One that
  /// was not yet taken is made anew after a command, so that its effect is seen at once.
  void request();

  /// Whether something that was sent is not carried out yet.
  bool commands_to_come();

  /// Seconds for which the runner has been at one step or command; 0 while it waits.
  double busy_for() const;

  /// Takes the requested snapshot if it is ready and returns whether it was; `snapshot()` is then
  /// the new one. Rethrows the exception that ended the runner's thread. `take` and `snapshot` are
  /// for one thread only.
  bool take();
  const LiveState& snapshot() const { return *front_; }

 private:
  void loop();
  bool wait_for_work(std::vector<Command>& commands);
  void apply(std::vector<Command>& commands);
  bool resting() const { return !session_.hurried() && !session_.running(); }
  void step(double now);
  void measure(double now);
  void publish();

  Options options_;

  // Used by the runner's thread only.
  Session session_;
  Pacer pacer_;
  double measured_from_ = 0, stepping_ = 0;
  double published_ = 0;  // when the last snapshot was handed out
  double steps_per_second_ = 0, microseconds_per_step_ = 0;
  int measured_steps_ = 0;
  bool commanded_ = false;  // since the last snapshot

  std::atomic<double> busy_since_ = 0;  // 0: it waits

  // Shared, under the mutex.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Command> queue_;
  bool requested_ = false, fresh_ = false, stop_ = false;
  std::exception_ptr failure_;

  // Three buffers: the runner fills back_, the window reads front_, and middle_ is handed over.
  std::array<LiveState, 3> buffers_;
  LiveState* back_ = &buffers_[0];
  LiveState* middle_ = &buffers_[1];
  LiveState* front_ = &buffers_[2];

  std::thread thread_;  // last: it starts when all other members exist
};

}  // namespace pupflow::window
