// The computing threads of one rank. The main thread of the rank handles the messages.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/mpi/message.h"

namespace pupflow::mpi {

class ThreadPool {
 public:
  struct Finished {
    std::int64_t run;
    std::optional<RunResult> result;  // empty if the run was stopped or failed
    std::exception_ptr failure;       // null unless the run failed
  };

  /// Starts `threads` threads. Each of them calls `stop` between the steps of a run.
  ThreadPool(int threads, std::function<bool()> stop);

  /// Stops unfinished tasks.
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// The number of idle threads; negative if tasks wait.
  int idle() const { return idle_; }

  /// Adds a task, which starts as soon as a thread is idle.
  void submit(const Task& task);

  /// Removes the task that finished first and returns it. Waits up to `timeout` for one; empty if
  /// there is none.
  std::optional<Finished> next_finished(std::chrono::milliseconds timeout);

 private:
  void work();
  std::function<bool()> stop_;
  int idle_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable task_added_, task_finished_;
  std::deque<Task> tasks_;
  std::deque<Finished> finished_;
  std::atomic<bool> closing_{false};  // read without the mutex between steps
  std::vector<std::jthread> threads_;
};

}  // namespace pupflow::mpi
