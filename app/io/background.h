// A second thread for work that need not be done at once, such as writing files.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace pupflow::io {

/// Does jobs one after the other on a thread of its own; where the system gives none, `run` does
/// them itself. After a job that threw, all others are left out. The destructor waits for the job at
/// hand and leaves out those behind it.
class Background {
 public:
  using Ticket = std::uint64_t;

  Background();
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Puts a job behind the others.
  Ticket run(std::function<void()> job);

  /// Returns when that job and all before it are done. Throws what a job threw.
  void wait(Ticket ticket);
  void wait_for_all() { wait(given_); }

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  Ticket given_ = 0, done_ = 0;
  bool stopped_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace pupflow::io
