// Which runs are still to be handed out, who has which, and which are finished.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace pupflow::mpi {

class Agenda {
 public:
  explicit Agenda(std::int64_t runs) : done_(static_cast<std::size_t>(runs)) {}

  bool finished() const { return count_ == static_cast<std::int64_t>(done_.size()); }

  /// A run for `rank`, the lowest first; nothing when all are handed out.
  std::optional<std::int64_t> take(int rank);

  /// How many runs `rank` has now.
  std::size_t held_by(int rank) const;

  /// Takes back what `rank` has.
  void give_back(int rank);

  /// `rank` has finished a run. False when another was faster, as after give_back().
  bool finish(int rank, std::int64_t run);

 private:
  std::vector<bool> done_;
  std::int64_t count_ = 0, next_ = 0;
  std::set<std::int64_t> returned_;
  std::map<int, std::set<std::int64_t>> held_;
};

}  // namespace pupflow::mpi
