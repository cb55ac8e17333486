#include "app/mpi/run_queue.h"

namespace pupflow::mpi {

std::optional<std::int64_t> RunQueue::assign(int rank) {
  std::int64_t run = next_;
  if (!requeued_.empty()) {
    run = *requeued_.begin();
    requeued_.erase(requeued_.begin());
  } else if (run < static_cast<std::int64_t>(finished_.size())) {
    ++next_;
  } else {
    return std::nullopt;
  }
  assigned_[rank].insert(run);
  return run;
}

std::size_t RunQueue::assigned_to(int rank) const {
  const auto runs = assigned_.find(rank);
  return runs == assigned_.end() ? 0 : runs->second.size();
}

void RunQueue::requeue(int rank) {
  for (const std::int64_t run : assigned_[rank]) {
    if (!finished_[static_cast<std::size_t>(run)]) requeued_.insert(run);
  }
  assigned_.erase(rank);
}

bool RunQueue::finish(int rank, std::int64_t run) {
  assigned_[rank].erase(run);
  requeued_.erase(run);
  if (finished_[static_cast<std::size_t>(run)]) return false;
  finished_[static_cast<std::size_t>(run)] = true;
  ++count_;
  return true;
}

}  // namespace pupflow::mpi
