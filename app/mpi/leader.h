// Rank 0: hands runs to ranks as they become free, and computes too.
#pragma once

#include <vector>

#include "app/mpi/agenda.h"
#include "app/mpi/pool.h"
#include "app/mpi/post.h"
#include "app/mpi/ranks.h"

namespace pupflow::mpi {

class Leader : public study::Crew {
 public:
  explicit Leader(const Membership& self);

  /// Sends the others home, without waiting for lost ones.
  ~Leader() override;

  /// Waits until every rank has said what it was told to do. Throws io::Failure(bad_input) when two
  /// were told different things.
  void muster();

  void compute(std::int64_t count, const std::function<Params(std::int64_t)>& params_of,
               const std::function<void(std::int64_t, const RunResult&)>& deliver,
               const std::function<bool()>& stop) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    enum class State { awaited, working, retired, gone };  // gone: it said bye
    State state = State::awaited;
    bool lost = false;  // silent for too long; taken back when it speaks again
    std::size_t threads = 0;
    Clock::time_point heard;
  };
  struct Work {  // of one call of compute()
    Agenda agenda;
    Pool pool;
    const std::function<Params(std::int64_t)>& params_of;
    const std::function<void(std::int64_t, const RunResult&)>& deliver;
  };

  void hand_out(Work& work);
  void collect(Work& work);
  void read_post(Work* work);
  void take(const Letter& letter, Work* work);
  void welcome(int rank, Worker& worker, const std::string& bytes);
  void look_after_others(Work* work);
  void leave();
  template <class Predicate>
  bool all(Predicate predicate) const;

  Membership self_;
  Post post_;
  std::vector<Worker> workers_;  // by rank; the first stands for this rank and is not used
  Clock::time_point looked_, beaten_;
  std::string difference_;  // between what two ranks were told to do
};

}  // namespace pupflow::mpi
