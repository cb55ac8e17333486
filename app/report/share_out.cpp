#include "app/report/share_out.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "app/io/interrupt.h"
#include "app/io/progress.h"

namespace pupflow::report {

void share_out(const std::string& what, std::int64_t count, const Options& options,
               const std::function<void(std::int64_t)>& work) {
  io::Progress progress(what, count, options.quiet);
  std::atomic<std::int64_t> next{0};
  std::mutex mutex;  // guards done, progress and failure
  std::int64_t done = 0;
  std::exception_ptr failure;
  const auto take = [&] {
    for (std::int64_t i = next++; i < count && !io::interrupted(); i = next++) {
      std::exception_ptr problem;
      try {
        work(i);
      } catch (...) {
        problem = std::current_exception();
        next = count;
      }
      const std::lock_guard lock(mutex);
      if (problem && !failure) failure = problem;
      progress.update(++done);
    }
  };
  {
    std::vector<std::jthread> helpers;
    const std::int64_t wanted = std::min<std::int64_t>(std::max(options.threads, 1), count);
    for (std::int64_t i = 1; i < wanted; ++i) helpers.emplace_back(take);
    take();
  }
  if (failure) std::rethrow_exception(failure);
  stop_if_interrupted();
}

}  // namespace pupflow::report
