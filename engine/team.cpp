#include "engine/team.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace pupflow {

/// All workers but the first. They wait for `round_` to change. The job is written before that, and
/// does not change until all have finished the round. Where the system gives fewer threads than
/// asked for, the first worker does the work of those that are missing.
class Team::Threads {
 public:
  explicit Threads(int count) : wanted_(count) {
    threads_.reserve(static_cast<std::size_t>(count));
    try {
      for (int i = 1; i <= count; ++i) {
        threads_.emplace_back([this, i] { serve(i); });
      }
    } catch (const std::system_error&) {
      // no more of them to be had
    }
  }

  ~Threads() {
    if (forked()) {
      // They run in the other process: nobody here can join them, or let go of them unjoined.
      static_cast<void>(new std::vector<std::thread>(std::move(threads_)));
      return;
    }
    stop_ = true;
    begin_round();
    for (std::thread& thread : threads_) thread.join();
  }

  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  /// Whether they can do a job of `workers`: they are as many, and not those of another process,
  /// of which this one is a fork.
  bool suffice(int workers) const { return workers <= wanted_ + 1 && !forked(); }

  void run(int workers, void (*call)(void*, int), void* job) {
    call_ = call;
    job_ = job;
    workers_ = workers;
    busy_.store(static_cast<int>(threads_.size()), std::memory_order_relaxed);
    begin_round();
    work(0);
    for (int i = static_cast<int>(threads_.size()) + 1; i < workers; ++i) work(i);
    for (int busy = busy_.load(); busy != 0; busy = busy_.load()) busy_.wait(busy);
    if (failed_.exchange(false)) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

 private:
  bool forked() const { return ::getpid() != process_; }

  void begin_round() {
    round_.fetch_add(1);
    round_.notify_all();
  }

  void work(int worker) {
    try {
      call_(job_, worker);
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }

  void serve(int worker) {
    for (std::uint32_t seen = 0;;) {
      round_.wait(seen);
      seen = round_.load();
      if (stop_) return;
      if (worker < workers_) work(worker);
      if (busy_.fetch_sub(1) == 1) busy_.notify_one();
    }
  }

  const int wanted_;  // the system may give fewer
  const pid_t process_ = ::getpid();
  std::atomic<std::uint32_t> round_{0};
  std::atomic<int> busy_{0};  // workers that have not finished this round
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;  // written by the worker that set failed_
  bool stop_ = false;
  int workers_ = 0;
  void (*call_)(void*, int) = nullptr;
  void* job_ = nullptr;
  std::vector<std::thread> threads_;
};

Team::Team(int threads) : size_(std::max(threads, 1)) {}
Team::Team(const Team& other) : Team(other.size_) {}
Team::Team(Team&&) noexcept = default;
Team& Team::operator=(const Team& other) {
  if (this != &other) *this = Team(other.size_);
  return *this;
}
Team& Team::operator=(Team&&) noexcept = default;
Team::~Team() = default;

void Team::run_together(int workers, void (*call)(void*, int), void* job) {
  assert(workers > 1 && workers <= size_);
  if (!threads_ || !threads_->suffice(workers)) threads_ = std::make_unique<Threads>(workers - 1);
  threads_->run(workers, call, job);
}

Share share_of(int count, int worker, int workers) {
  assert(count >= 0 && worker >= 0 && worker < workers);
  const auto cut = [&](int i) {
    return static_cast<int>(static_cast<std::int64_t>(count) * i / workers);
  };
  return {cut(worker), cut(worker + 1)};
}

int useful_workers(const Team& team, int pups) {
  constexpr int kPupsWorthAThread = 24;
  return std::clamp(pups / kPupsWorthAThread, 1, team.size());
}

}  // namespace pupflow
