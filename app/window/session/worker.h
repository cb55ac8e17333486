// A thread that does one piece of work at a time for the window.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace pupflow::window {

class Worker {
 public:
  /// `notify` is called on the worker's thread after each piece of work.
  explicit Worker(std::function<void()> notify);
  /// Waits for the work under way.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Begins `work`; none may be under way.
  void start(std::function<void()> work);

  /// Whether there is nothing to wait for, after waiting for at most so many seconds. Rethrows what
  /// the work threw, once.
  bool done_within(double seconds);
  bool busy() { return !done_within(0); }

 private:
  void loop();

  std::function<void()> notify_, work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool working_ = false, stop_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // last: it starts when all other members exist
};

}  // namespace pupflow::window
