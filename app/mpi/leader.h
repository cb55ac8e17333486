// Rank 0: assigns runs to ranks as they become free, and computes runs too.
#pragma once

#include <vector>

#include "app/mpi/heartbeat.h"
#include "app/mpi/interface.h"
#include "app/mpi/mailbox.h"
#include "app/mpi/run_queue.h"
#include "app/mpi/thread_pool.h"

namespace pupflow::mpi {

class Leader : public study::Executor {
 public:
  explicit Leader(const RankInfo& self);

  ~Leader() override;

  /// Waits until every rank has said hello or is lost. Throws io::Failure(bad_input) if the command
  /// lines of two ranks differ, or one cannot take part.
  void wait_for_workers();

  void compute(std::int64_t count, const std::function<Params(std::int64_t)>& params_of,
               const std::function<void(std::int64_t, const RunResult&)>& deliver,
               const std::function<bool()>& stop, std::int64_t series_every) override;

  /// Stops the other ranks, once; the destructor does it, too. Does not wait for lost ones.
  void release() override;

 private:
  struct Peer {  // another rank
    enum class State { starting, working, failed, stopped };
    State state = State::starting;
    bool lost = false;  // until it sends a message again
    std::size_t threads = 0;
    Clock::time_point heard;  // its last message
  };
  struct Batch {  // the runs of one call of compute()
    RunQueue queue;
    ThreadPool pool;
    const std::function<Params(std::int64_t)>& params_of;
    const std::function<void(std::int64_t, const RunResult&)>& deliver;
    std::int64_t series_every;
  };

  void assign_runs(Batch& batch);
  void collect_own_results(Batch& batch);
  void handle(const Message& message, Batch* batch);
  void handle_hello(int rank, Peer& peer, const std::string& bytes);
  void check_heartbeats(Batch* batch);
  /// Receives all messages and checks heartbeats; `batch` is null outside compute().
  void communicate(Batch* batch);
  /// Communicates until `predicate` is true for all other ranks, or this process is interrupted.
  template <class Predicate>
  void wait_until_all(Predicate predicate);
  void stop_workers();

  RankInfo self_;
  Mailbox mailbox_;
  std::vector<Peer> peers_;  // by rank; the first is this rank's and is not used
  HeartbeatTimer timer_;
  bool released_ = false;
  std::string refusal_;  // why the job cannot start; empty if it can
};

}  // namespace pupflow::mpi
