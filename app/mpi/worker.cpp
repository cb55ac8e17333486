#include "app/mpi/worker.h"

#include <cstdio>
#include <optional>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/mpi/pool.h"
#include "app/mpi/post.h"

namespace pupflow::mpi {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{2};
constexpr int kLeader = 0;

std::string reason(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  }
}

class Worker {
 public:
  explicit Worker(const Membership& self) : self_(self) { pool_.emplace(self.threads, stop_); }

  void work() {
    post_.send(kLeader, Subject::hello, pack(Hello{self_.threads}) + self_.job);
    while (!sent_home_) {
      report();
      read_post();
      give_signs_of_life();
    }
    pool_.reset();
    post_.send(kLeader, Subject::bye);
    while (!leave_) {
      std::this_thread::sleep_for(kPause);
      read_post();
      give_signs_of_life();
    }
    if (leave_->together) {
      MPI_Finalize();
    } else {
      // Rank 0 goes first, with the program's exit code, and takes the others with it if it can.
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }

 private:
  void report() {
    if (!pool_) return std::this_thread::sleep_for(kPause);
    const auto done = pool_->finished(kPause);
    if (!done) return;
    if (done->failure) return retire(reason(done->failure));
    if (done->result) {
      post_.send(kLeader, Subject::result, pack(Result{done->run, *done->result}));
    }
  }

  /// Stays until it is sent home: a rank that leaves early takes the whole job with it.
  void retire(const std::string& why) {
    pool_.reset();
    post_.send(kLeader, Subject::failed, why);
  }

  void read_post() {
    while (const std::optional<Letter> letter = post_.receive()) {
      heard_ = Clock::now();
      if (letter->subject == Subject::task && pool_) pool_->begin(unpack<Task>(letter->bytes));
      if (letter->subject == Subject::home) sent_home_ = true;
      if (letter->subject == Subject::leave) leave_ = unpack<Leave>(letter->bytes);
    }
  }

  void give_signs_of_life() {
    if (io::interrupted()) {
      // The launcher kills all ranks as soon as one has left: rank 0 goes first and says how far
      // the sweep came. The launcher grants about a second.
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      throw io::Failure(io::ExitCode::interrupted, "interrupted");
    }
    const Clock::time_point now = Clock::now();
    if (now - looked_ > self_.lost_after / 4) heard_ = now;  // held up itself
    looked_ = now;
    if (now - heard_ > self_.lost_after) {
      // Said here: what comes after rank 0 speaks for all ranks, and it is no more.
      std::fprintf(stderr, "pupflow: rank %d leaves: rank 0 has been silent for too long\n",
                   self_.rank);
      throw io::Failure(io::ExitCode::interrupted, "rank 0 has been silent for too long");
    }
    if (now - beaten_ < self_.lost_after / 8) return;
    beaten_ = now;
    if (post_.sent(kLeader)) post_.send(kLeader, Subject::beat);
  }

  Membership self_;
  Post post_;
  std::function<bool()> stop_ = [] { return io::interrupted(); };
  std::optional<Pool> pool_;
  bool sent_home_ = false;
  std::optional<Leave> leave_;
  Clock::time_point heard_ = Clock::now(), looked_ = heard_, beaten_ = heard_;
};

}  // namespace

void work_for_leader(const Membership& self) {
  Worker(self).work();
}

}  // namespace pupflow::mpi
