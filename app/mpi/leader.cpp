#include "app/mpi/leader.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::mpi {
namespace {

constexpr std::chrono::milliseconds kPause{2};  // between two looks at the post

void warn(int rank, const std::string& what) {
  std::fprintf(stderr, "pupflow: rank %d %s\n", rank, what.c_str());
}

/// MPI_Finalize would wait for a rank that is no more, and the launcher for one that hangs: once
/// this program has written and said everything, it takes the whole job down, with its own code.
void abort_job_at_exit() {
  const auto abort_job = [](int code, void*) {
    std::fflush(nullptr);  // MPI_Abort does not
    MPI_Abort(MPI_COMM_WORLD, code);
  };
  ::on_exit(abort_job, nullptr);
}

}  // namespace

Leader::Leader(const Membership& self) : self_(self) {
  workers_.resize(static_cast<std::size_t>(post_.size()));
  looked_ = beaten_ = Clock::now();
  for (Worker& worker : workers_) worker.heard = looked_;
}

Leader::~Leader() {
  leave();
}

template <class Predicate>
bool Leader::all(Predicate predicate) const {
  return std::all_of(workers_.begin() + 1, workers_.end(), predicate);
}

void Leader::muster() {
  const auto here = [](const Worker& worker) {
    return worker.lost || worker.state != Worker::State::awaited;
  };
  while (!all(here) && !io::interrupted()) {
    read_post(nullptr);
    look_after_others(nullptr);
    std::this_thread::sleep_for(kPause);
  }
  if (!difference_.empty()) throw io::Failure(io::ExitCode::bad_input, difference_);
}

void Leader::compute(std::int64_t count, const std::function<Params(std::int64_t)>& params_of,
                     const std::function<void(std::int64_t, const RunResult&)>& deliver,
                     const std::function<bool()>& stop) {
  Work work{Agenda(count), {self_.threads, stop}, params_of, deliver};
  while (!work.agenda.finished() && !stop()) {
    hand_out(work);
    collect(work);
    read_post(&work);
    look_after_others(&work);
  }
}

void Leader::hand_out(Work& work) {
  const auto next = [&](int rank) -> std::optional<Task> {
    const std::optional<std::int64_t> run = work.agenda.take(rank);
    if (!run) return std::nullopt;
    return Task{*run, work.params_of(*run)};
  };
  // One each in turn, so that a short sweep is not taken by the first rank that has many threads.
  for (bool more = true; more;) {
    more = false;
    for (int rank = post_.size() - 1; rank > 0; --rank) {
      const Worker& worker = workers_[static_cast<std::size_t>(rank)];
      if (worker.state != Worker::State::working || worker.lost ||
          work.agenda.held_by(rank) >= worker.threads) {
        continue;
      }
      const std::optional<Task> task = next(rank);
      if (!task) return;
      post_.send(rank, Subject::task, pack(*task));
      more = true;
    }
    if (work.pool.room() > 0) {
      const std::optional<Task> task = next(0);
      if (!task) return;
      work.pool.begin(*task);
      more = true;
    }
  }
}

void Leader::collect(Work& work) {
  for (auto done = work.pool.finished(kPause); done; done = work.pool.finished({})) {
    if (done->failure) std::rethrow_exception(done->failure);
    if (!done->result) continue;  // stopped
    if (work.agenda.finish(0, done->run)) work.deliver(done->run, *done->result);
  }
}

void Leader::read_post(Work* work) {
  while (const std::optional<Letter> letter = post_.receive()) take(*letter, work);
}

void Leader::take(const Letter& letter, Work* work) {
  Worker& worker = workers_[static_cast<std::size_t>(letter.from)];
  worker.heard = Clock::now();
  if (worker.lost) warn(letter.from, "is back");
  worker.lost = false;
  switch (letter.subject) {
    case Subject::hello:
      welcome(letter.from, worker, letter.bytes);
      break;
    case Subject::result: {
      if (!work) break;  // too late to be of use
      const Result result = unpack<Result>(letter.bytes);
      if (work->agenda.finish(letter.from, result.run)) work->deliver(result.run, result.result);
      break;
    }
    case Subject::failed:
      warn(letter.from, "computes no more: " + letter.bytes);
      worker.state = Worker::State::retired;
      if (work) work->agenda.give_back(letter.from);
      break;
    case Subject::bye:
      worker.state = Worker::State::gone;
      break;
    case Subject::beat:
    case Subject::task:
    case Subject::home:
    case Subject::leave:
      break;
  }
}

void Leader::welcome(int rank, Worker& worker, const std::string& bytes) {
  const std::string job = bytes.substr(sizeof(Hello));
  worker.threads = static_cast<std::size_t>(unpack<Hello>(bytes).threads);
  worker.state = Worker::State::working;
  if (job == self_.job) return;
  difference_ = "all ranks work on one sweep, but rank 0 was started as '" + self_.job +
                "' and rank " + std::to_string(rank) + " as '" + job +
                "'; processes that go their own ways need no MPI (srun --mpi=none)";
}

/// Signs of life in both directions.
void Leader::look_after_others(Work* work) {
  const Clock::time_point now = Clock::now();
  // A leader that was itself held up (stopped, or a slow disk) must not blame the others for it.
  const Clock::duration held_up = now - looked_;
  looked_ = now;
  const bool beat = now - beaten_ >= self_.lost_after / 8;
  if (beat) beaten_ = now;
  for (int rank = 1; rank < post_.size(); ++rank) {
    Worker& worker = workers_[static_cast<std::size_t>(rank)];
    if (held_up > self_.lost_after / 4) worker.heard = now;
    if (beat && post_.sent(rank)) post_.send(rank, Subject::beat);
    if (worker.lost || worker.state == Worker::State::gone) continue;
    if (now - worker.heard <= self_.lost_after) continue;
    worker.lost = true;
    if (work) work->agenda.give_back(rank);
    warn(rank, "has been silent for too long; its runs go to others");
  }
}

/// Nobody may be left hanging, and nothing here may wait for a rank that is no more.
void Leader::leave() {
  for (int rank = 1; rank < post_.size(); ++rank) post_.send(rank, Subject::home);
  const auto settled = [](const Worker& worker) {
    return worker.lost || worker.state == Worker::State::gone;
  };
  while (!all(settled) && !io::interrupted()) {
    read_post(nullptr);
    look_after_others(nullptr);
    std::this_thread::sleep_for(kPause);
  }
  if (io::interrupted()) return;  // the launcher ends the job, and waits for nobody
  const bool together =
      all([](const Worker& worker) { return worker.state == Worker::State::gone; });
  for (int rank = 1; rank < post_.size(); ++rank) {
    post_.send(rank, Subject::leave, pack(Leave{together}));
  }
  if (together) {
    MPI_Finalize();
  } else {
    abort_job_at_exit();
  }
}

}  // namespace pupflow::mpi
