#include "app/mpi/agenda.h"

namespace pupflow::mpi {

std::optional<std::int64_t> Agenda::take(int rank) {
  std::int64_t run = next_;
  if (!returned_.empty()) {
    run = *returned_.begin();
    returned_.erase(returned_.begin());
  } else if (run < static_cast<std::int64_t>(done_.size())) {
    ++next_;
  } else {
    return std::nullopt;
  }
  held_[rank].insert(run);
  return run;
}

std::size_t Agenda::held_by(int rank) const {
  const auto runs = held_.find(rank);
  return runs == held_.end() ? 0 : runs->second.size();
}

void Agenda::give_back(int rank) {
  for (const std::int64_t run : held_[rank]) {
    if (!done_[static_cast<std::size_t>(run)]) returned_.insert(run);
  }
  held_.erase(rank);
}

bool Agenda::finish(int rank, std::int64_t run) {
  held_[rank].erase(run);
  returned_.erase(run);
  if (done_[static_cast<std::size_t>(run)]) return false;
  done_[static_cast<std::size_t>(run)] = true;
  ++count_;
  return true;
}

}  // namespace pupflow::mpi
