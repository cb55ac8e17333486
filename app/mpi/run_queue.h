// The runs of a sweep: which wait, which rank computes which, and which are finished.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace pupflow::mpi {

class RunQueue {
 public:
  /// Runs 0 ... `runs` - 1, all waiting.
  explicit RunQueue(std::int64_t runs) : finished_(static_cast<std::size_t>(runs)) {}

  bool all_finished() const { return count_ == static_cast<std::int64_t>(finished_.size()); }

  /// Assigns a waiting run to `rank`: a requeued one if there is one, then the lowest. Empty when
  /// none waits.
  std::optional<std::int64_t> assign(int rank);

  /// The number of runs assigned to `rank` and not finished.
  std::size_t assigned_to(int rank) const;

  /// Lets the unfinished runs of `rank` wait again.
  void requeue(int rank);

  /// Marks a run as finished by `rank`. False if it was finished before: after requeue() two ranks
  /// may compute the same run.
  bool finish(int rank, std::int64_t run);

 private:
  std::vector<bool> finished_;
  std::int64_t count_ = 0, next_ = 0;  // how many are finished; the first never assigned
  std::set<std::int64_t> requeued_;
  std::map<int, std::set<std::int64_t>> assigned_;
};

}  // namespace pupflow::mpi
