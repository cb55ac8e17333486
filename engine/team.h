// Threads that share the work on one litter.
#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>

namespace pupflow {

/// A group of workers that run jobs together, one job after another. The calling thread is worker
/// 0. The other threads start with the first job that needs them and wait between jobs; after a
/// fork(), the new process starts its own. A copy is a team of its own, of the same size.
class Team {
 public:
  /// A team of `threads` workers, at least one.
  explicit Team(int threads = 1);
  Team(const Team& other);
  Team(Team&&) noexcept;
  Team& operator=(const Team& other);
  Team& operator=(Team&&) noexcept;
  ~Team();

  int size() const { return size_; }

  /// Calls `job(worker)` once for each worker 0 ... workers - 1, at the same time, and returns when
  /// all are done. If calls throw, one of their exceptions is then thrown here. `workers` is at
  /// most size().
  template <class Job>
  void run(int workers, Job&& job) {
    if (workers <= 1) {
      job(0);
      return;
    }
    using Plain = std::remove_reference_t<Job>;
    run_together(
        workers, [](void* call, int worker) { (*static_cast<Plain*>(call))(worker); },
        const_cast<void*>(static_cast<const void*>(&job)));
  }

 private:
  class Threads;
  void run_together(int workers, void (*call)(void*, int), void* job);

  int size_;
  std::unique_ptr<Threads> threads_;  // none before the first job for more than one
};

/// The items begin ... end - 1 of a loop, which one worker does.
struct Share {
  int begin, end;
};

/// Share number `worker` of `workers` equal shares of `count` items, in order.
Share share_of(int count, int worker, int workers);

/// How many workers of `team` to use for `pups` pups, at least 1: with few pups, waking another
/// thread takes longer than the work that it takes over.
int useful_workers(const Team& team, int pups);

}  // namespace pupflow
