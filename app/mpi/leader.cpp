#include "app/mpi/leader.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::mpi {
namespace {

void warn(int rank, const std::string& what) {
  std::fprintf(stderr, "pupflow: rank %d %s\n", rank, what.c_str());
}

/// Ends the whole job with the exit code of this process, after its last output. For a job with a
/// lost rank: MPI_Finalize would wait for a rank that died, and the launcher for one that hangs.
void abort_job_at_exit() {
  const auto abort_job = [](int code, void*) {
    std::fflush(nullptr);  // MPI_Abort does not
    MPI_Abort(MPI_COMM_WORLD, code);
  };
  ::on_exit(abort_job, nullptr);
}

}  // namespace

Leader::Leader(const RankInfo& self) : self_(self), timer_(self.lost_after, Clock::now()) {
  peers_.resize(static_cast<std::size_t>(mailbox_.size()));
  for (Peer& peer : peers_) peer.heard = Clock::now();
}

Leader::~Leader() {
  Leader::release();
}

void Leader::release() {
  if (released_) return;
  released_ = true;
  try {
    stop_workers();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pupflow: rank 0 cannot stop the other ranks: %s\n", error.what());
    abort_job_at_exit();
  }
}

template <class Predicate>
void Leader::wait_until_all(Predicate predicate) {
  while (!std::all_of(peers_.begin() + 1, peers_.end(), predicate) && !io::interrupted()) {
    communicate(nullptr);
    std::this_thread::sleep_for(kPollInterval);
  }
}

void Leader::wait_for_workers() {
  wait_until_all([](const Peer& peer) { return peer.lost || peer.state != Peer::State::starting; });
  if (refusal_.empty()) return;
  const std::vector<std::string_view> lines = io::split(refusal_, '\n');
  io::refuse_all({lines.begin(), lines.end()});
}

void Leader::compute(std::int64_t count, const std::function<Params(std::int64_t)>& params_of,
                     const std::function<void(std::int64_t, const RunResult&)>& deliver,
                     const std::function<bool()>& stop, std::int64_t series_every) {
  Batch batch{RunQueue(count), {self_.threads, stop}, params_of, deliver, series_every};
  while (!batch.queue.all_finished() && !stop()) {
    assign_runs(batch);
    collect_own_results(batch);
    communicate(&batch);
  }
}

void Leader::assign_runs(Batch& batch) {
  const auto next_task = [&](int rank) -> std::optional<Task> {
    const std::optional<std::int64_t> run = batch.queue.assign(rank);
    if (!run) return std::nullopt;
    return Task{*run, batch.series_every, batch.params_of(*run)};
  };
  // One run per rank in turn, so that a rank with many threads does not get all runs of a short
  // sweep.
  for (bool more = true; more;) {
    more = false;
    for (int rank = mailbox_.size() - 1; rank > 0; --rank) {
      const Peer& peer = peers_[static_cast<std::size_t>(rank)];
      if (peer.state != Peer::State::working || peer.lost ||
          batch.queue.assigned_to(rank) >= peer.threads) {
        continue;
      }
      const std::optional<Task> task = next_task(rank);
      if (!task) return;
      mailbox_.send(rank, Tag::task, pack(*task));
      more = true;
    }
    if (batch.pool.idle() > 0) {
      const std::optional<Task> task = next_task(0);
      if (!task) return;
      batch.pool.submit(*task);
      more = true;
    }
  }
}

void Leader::collect_own_results(Batch& batch) {
  auto done = batch.pool.next_finished(kPollInterval);
  for (; done; done = batch.pool.next_finished({})) {
    if (done->failure) std::rethrow_exception(done->failure);
    if (!done->result) continue;  // stopped
    if (batch.queue.finish(0, done->run)) batch.deliver(done->run, *done->result);
  }
}

void Leader::communicate(Batch* batch) {
  while (const std::optional<Message> message = mailbox_.receive()) handle(*message, batch);
  check_heartbeats(batch);
}

void Leader::handle(const Message& message, Batch* batch) {
  Peer& peer = peers_[static_cast<std::size_t>(message.source)];
  peer.heard = Clock::now();
  if (peer.lost) warn(message.source, "is back: a message arrived");
  peer.lost = false;
  switch (message.tag) {
    case Tag::hello:
      handle_hello(message.source, peer, message.bytes);
      break;
    case Tag::refused:
      peer.state = Peer::State::failed;
      refusal_ = "rank " + std::to_string(message.source) + ": " + message.bytes;
      break;
    case Tag::result: {
      if (!batch) break;  // compute() has returned
      const Result result = unpack_result(message.bytes);
      if (batch->queue.finish(message.source, result.run)) {
        batch->deliver(result.run, result.result);
      }
      break;
    }
    case Tag::failed:
      warn(message.source, "failed and computes no more runs: " + message.bytes);
      peer.state = Peer::State::failed;
      if (batch) batch->queue.requeue(message.source);
      break;
    case Tag::stopped:
      peer.state = Peer::State::stopped;
      break;
    case Tag::heartbeat:
    case Tag::task:
    case Tag::stop:
    case Tag::shutdown:
      break;
  }
}

void Leader::handle_hello(int rank, Peer& peer, const std::string& bytes) {
  peer.threads = static_cast<std::size_t>(unpack<Hello>(bytes).threads);
  peer.state = Peer::State::working;
  const std::string command = bytes.substr(sizeof(Hello));
  if (command == self_.command || !refusal_.empty()) return;
  refusal_ = "all ranks must be started with the same command, but rank 0 has '" + self_.command +
             "' and rank " + std::to_string(rank) + " has '" + command +
             "'; start independent processes without MPI (srun --mpi=none)";
}

void Leader::check_heartbeats(Batch* batch) {
  const Clock::time_point now = Clock::now();
  const HeartbeatTimer::Check check = timer_.check(now);
  for (int rank = 1; rank < mailbox_.size(); ++rank) {
    Peer& peer = peers_[static_cast<std::size_t>(rank)];
    if (check.paused) peer.heard = now;
    if (check.send && mailbox_.all_sent(rank)) mailbox_.send(rank, Tag::heartbeat);
    if (peer.lost || peer.state == Peer::State::stopped) continue;
    if (!timer_.is_lost(peer.heard, now)) continue;
    peer.lost = true;
    if (batch) batch->queue.requeue(rank);
    warn(rank, "is lost: no message for " + std::to_string(self_.lost_after.count()) +
                   " s; other ranks compute its runs");
  }
}

/// No rank may wait forever, and this one may not wait for a lost rank.
void Leader::stop_workers() {
  for (int rank = 1; rank < mailbox_.size(); ++rank) mailbox_.send(rank, Tag::stop);
  wait_until_all([](const Peer& peer) { return peer.lost || peer.state == Peer::State::stopped; });
  if (io::interrupted()) return;  // the launcher ends the job at once
  const bool finalize = std::all_of(peers_.begin() + 1, peers_.end(), [](const Peer& peer) {
    return peer.state == Peer::State::stopped;
  });
  for (int rank = 1; rank < mailbox_.size(); ++rank) {
    mailbox_.send(rank, Tag::shutdown, pack(Shutdown{finalize}));
  }
  if (finalize) {
    MPI_Finalize();
  } else {
    abort_job_at_exit();
  }
}

}  // namespace pupflow::mpi
