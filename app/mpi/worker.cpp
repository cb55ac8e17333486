#include "app/mpi/worker.h"

#include <cstdio>
#include <optional>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/mpi/heartbeat.h"
#include "app/mpi/mailbox.h"
#include "app/mpi/thread_pool.h"

namespace pupflow::mpi {
namespace {

constexpr int kLeader = 0;

std::string message_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  }
}

class Worker {
 public:
  /// One that computes, or one that only says why it cannot.
  explicit Worker(const RankInfo& self, std::string refusal = {})
      : self_(self), refusal_(std::move(refusal)) {
    if (refusal_.empty()) pool_.emplace(self.threads, io::interrupted);
  }

  void run() {
    if (refusal_.empty()) {
      mailbox_.send(kLeader, Tag::hello, pack(Hello{self_.threads}) + self_.command);
    } else {
      mailbox_.send(kLeader, Tag::refused, refusal_);
    }
    while (!stop_) {
      send_result();
      communicate();
    }
    pool_.reset();
    mailbox_.send(kLeader, Tag::stopped);
    while (!shutdown_) {
      std::this_thread::sleep_for(kPollInterval);
      communicate();
    }
    if (shutdown_->finalize) {
      MPI_Finalize();
    } else {
      // Rank 0 exits first, with the program's exit code, and ends the other ranks if it can.
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }

 private:
  /// Waits for a result up to the poll interval.
  void send_result() {
    if (!pool_) return std::this_thread::sleep_for(kPollInterval);
    const auto done = pool_->next_finished(kPollInterval);
    if (!done) return;
    if (done->failure) {
      // This process must go on until rank 0 stops it: if it ended, the launcher would end the job.
      pool_.reset();
      mailbox_.send(kLeader, Tag::failed, message_of(done->failure));
    } else if (done->result) {
      mailbox_.send(kLeader, Tag::result, pack_result({done->run, *done->result}));
    }
  }

  void communicate() {
    receive_messages();
    throw_if_interrupted();
    check_heartbeats();
  }

  void receive_messages() {
    while (const std::optional<Message> message = mailbox_.receive()) {
      heard_ = Clock::now();
      if (message->tag == Tag::task && pool_) pool_->submit(unpack_task(message->bytes));
      if (message->tag == Tag::stop) stop_ = true;
      if (message->tag == Tag::shutdown) shutdown_ = unpack<Shutdown>(message->bytes);
    }
  }

  static void throw_if_interrupted() {
    if (!io::interrupted()) return;
    // The launcher kills all ranks when the first one exits, and grants about a second after the
    // signal. Wait, so that rank 0 exits first and prints how many runs are finished.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    throw io::Failure(io::ExitCode::interrupted, "interrupted");
  }

  void check_heartbeats() {
    const Clock::time_point now = Clock::now();
    const HeartbeatTimer::Check check = timer_.check(now);
    if (check.paused) heard_ = now;
    if (timer_.is_lost(heard_, now)) {
      const std::string reason =
          "no message from rank 0 for " + std::to_string(self_.lost_after.count()) + " s";
      // Printed here, since main() prints errors on rank 0 only.
      std::fprintf(stderr, "pupflow: rank %d stops: %s\n", self_.rank, reason.c_str());
      throw io::Failure(io::ExitCode::interrupted, reason);
    }
    if (check.send && mailbox_.all_sent(kLeader)) mailbox_.send(kLeader, Tag::heartbeat);
  }

  RankInfo self_;
  std::string refusal_;
  Mailbox mailbox_;
  std::optional<ThreadPool> pool_;  // empty after a refusal, a failure and a stop
  bool stop_ = false;               // rank 0 has sent Tag::stop
  std::optional<Shutdown> shutdown_;
  Clock::time_point heard_ = Clock::now();  // the last message from rank 0
  HeartbeatTimer timer_{self_.lost_after, heard_};
};

}  // namespace

void run_worker(const RankInfo& self) {
  Worker(self).run();
}

void refuse_work(const RankInfo& self, const std::string& why) {
  Worker(self, why).run();
}

}  // namespace pupflow::mpi
