#include "app/mpi/thread_pool.h"

#include <system_error>
#include <utility>

namespace pupflow::mpi {

ThreadPool::ThreadPool(int threads, std::function<bool()> stop)
    : stop_(std::move(stop)), idle_(threads) {
  threads_.reserve(static_cast<std::size_t>(threads));
  try {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
    if (threads_.empty()) throw;
    idle_ = static_cast<int>(threads_.size());  // fewer do the work
  }
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  task_added_.notify_all();
}

void ThreadPool::submit(const Task& task) {
  --idle_;
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(task);
  }
  task_added_.notify_one();
}

std::optional<ThreadPool::Finished> ThreadPool::next_finished(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  if (!task_finished_.wait_for(lock, timeout, [this] { return !finished_.empty(); }))
    return std::nullopt;
  std::optional<Finished> first(std::move(finished_.front()));
  finished_.pop_front();
  ++idle_;
  return first;
}

void ThreadPool::work() {
  while (true) {
    std::unique_lock lock(mutex_);
    task_added_.wait(lock, [this] { return closing_ || !tasks_.empty(); });
    if (closing_) return;
    const Task task = tasks_.front();
    tasks_.pop_front();
    lock.unlock();
    Finished finished{task.run, std::nullopt, nullptr};
    try {
      finished.result = run_to_end(
          task.params, [this] { return closing_ || stop_(); }, task.series_every);
    } catch (...) {
      finished.failure = std::current_exception();  // for the main thread to rethrow or report
    }
    lock.lock();
    finished_.push_back(std::move(finished));
    lock.unlock();
    task_finished_.notify_one();
  }
}

}  // namespace pupflow::mpi
