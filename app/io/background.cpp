#include "app/io/background.h"

#include <system_error>
#include <utility>

namespace pupflow::io {
namespace {

/// Does the job; what it threw, or nothing.
std::exception_ptr failure_of(const std::function<void()>& job) {
  try {
    job();
    return nullptr;
  } catch (...) {
    return std::current_exception();
  }
}

}  // namespace

Background::Background() {
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
    // no thread to be had
  }
}

Background::~Background() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Background::Ticket Background::run(std::function<void()> job) {
  if (!thread_.joinable()) {
    if (!failure_) failure_ = failure_of(job);
    ++done_;
    return ++given_;
  }
  const std::lock_guard lock(mutex_);
  jobs_.push_back(std::move(job));
  changed_.notify_all();
  return ++given_;
}

void Background::wait(Ticket ticket) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return done_ >= ticket; });
  if (failure_) std::rethrow_exception(failure_);
}

void Background::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return stopped_ || !jobs_.empty(); });
    if (stopped_) return;
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    if (!failure_) {
      lock.unlock();
      const std::exception_ptr failure = failure_of(job);
      lock.lock();
      failure_ = failure;
    }
    ++done_;
    changed_.notify_all();
  }
}

}  // namespace pupflow::io
