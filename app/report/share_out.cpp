#include "app/report/share_out.h"

#include <mutex>

#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "pupflow/ensemble.h"

namespace pupflow::report {

void share_out(const std::string& what, std::int64_t count, const Options& options,
               const std::function<void(std::int64_t)>& work) {
  io::Progress progress(what, count, options.quiet);
  std::mutex mutex;  // guards done and progress
  std::int64_t done = 0;
  for_each_index(count, options.threads, [&](std::int64_t i) {
    if (io::interrupted()) return;
    work(i);
    const std::lock_guard lock(mutex);
    progress.update(++done);
  });
  stop_if_interrupted();
}

}  // namespace pupflow::report
