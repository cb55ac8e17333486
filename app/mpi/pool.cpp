#include "app/mpi/pool.h"

#include <utility>

namespace pupflow::mpi {

Pool::Pool(int threads, std::function<bool()> stop) : stop_(std::move(stop)), room_(threads) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

Pool::~Pool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  task_came_.notify_all();
}

void Pool::begin(const Task& task) {
  --room_;
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(task);
  }
  task_came_.notify_one();
}

std::optional<Pool::Finished> Pool::finished(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  if (!task_finished_.wait_for(lock, patience, [this] { return !finished_.empty(); }))
    return std::nullopt;
  Finished first = std::move(finished_.front());
  finished_.pop_front();
  ++room_;
  return first;
}

void Pool::work() {
  while (true) {
    std::unique_lock lock(mutex_);
    task_came_.wait(lock, [this] { return closing_ || !tasks_.empty(); });
    if (closing_) return;
    const Task task = tasks_.front();
    tasks_.pop_front();
    lock.unlock();
    Finished finished{task.run, std::nullopt, nullptr};
    try {
      finished.result = run_to_end(task.params, [this] { return closing_ || stop_(); });
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
