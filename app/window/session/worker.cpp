#include "app/window/session/worker.h"

#include <chrono>
#include <utility>

namespace pupflow::window {

Worker::Worker(std::function<void()> notify)
    : notify_(std::move(notify)), thread_([this] { loop(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Worker::start(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    work_ = std::move(work);
    working_ = true;
  }
  changed_.notify_all();
}

bool Worker::done_within(double seconds) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return !working_; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return !working_;
}

void Worker::loop() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return working_ || stop_; });
    if (!working_) return;
    lock.unlock();
    std::exception_ptr failure;
    try {
      work_();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    failure_ = failure;
    working_ = false;
    changed_.notify_all();
    lock.unlock();
    if (notify_) notify_();
    lock.lock();
  }
}

}  // namespace pupflow::window
