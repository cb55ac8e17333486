// The threads of one rank that compute, while its main thread talks to the others.
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

#include "app/mpi/letter.h"

namespace pupflow::mpi {

class Pool {
 public:
  /// What came of a task.
  struct Finished {
    std::int64_t run;
    std::optional<RunResult> result;  // nothing when it was stopped or failed
    std::exception_ptr failure;
  };

  /// `stop` is asked by all threads, between the steps of their runs.
  Pool(int threads, std::function<bool()> stop);

  /// Gives up what is not finished.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// How many threads have nothing to do; negative when tasks wait.
  int room() const { return room_; }

  /// Begins a task as soon as a thread is free.
  void begin(const Task& task);

  /// The next finished task; waits for one up to `patience`.
  std::optional<Finished> finished(std::chrono::milliseconds patience);

 private:
  void work();
  std::function<bool()> stop_;
  int room_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable task_came_, task_finished_;
  std::deque<Task> tasks_;
  std::deque<Finished> finished_;
  std::atomic<bool> closing_{false};  // read without the mutex between steps
  std::vector<std::jthread> threads_;
};

}  // namespace pupflow::mpi
