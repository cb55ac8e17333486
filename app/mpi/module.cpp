// The MPI module: implements the interface.
#include <mpi.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "app/io/failure.h"
#include "app/mpi/leader.h"
#include "app/mpi/worker.h"

namespace pupflow::mpi {
namespace {

/// For example "Open MPI v4.1.4".
std::string library_name() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string whole(text.data(), static_cast<std::size_t>(length));
  return whole.substr(0, whole.find_first_of(",\n"));
}

/// Initialises MPI. Throws io::Failure(bad_input) if MPI and the launcher disagree about rank or
/// size: a launcher that belongs to another MPI starts independent processes, and each of them
/// would compute the whole sweep.
void initialise(const RankInfo& self) {
  int provided = MPI_THREAD_SINGLE, rank = 0, size = 1;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (rank == self.rank && size == self.size && provided >= MPI_THREAD_FUNNELED) return;
  MPI_Finalize();
  throw io::Failure(io::ExitCode::bad_input,
                    "started as one of " + std::to_string(self.size) + " ranks, but " +
                        library_name() + " sees " + std::to_string(size) +
                        ": start it with the mpirun of this MPI, or with srun --mpi=pmix");
}

/// Ends the process if MPI is not initialised in time: MPI_Init waits for all ranks.
class Watchdog {
 public:
  Watchdog(std::chrono::seconds limit, int code) {
    std::thread([limit, code, done = done_] {
      std::this_thread::sleep_for(limit);
      if (!*done) ::_exit(code);
    }).detach();
  }
  ~Watchdog() { *done_ = true; }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  std::shared_ptr<std::atomic<bool>> done_ = std::make_shared<std::atomic<bool>>(false);
};

class Module final : public Interface {
 public:
  std::unique_ptr<study::Executor> start_leader(const RankInfo& self) override {
    initialise(self);
    auto leader = std::make_unique<Leader>(self);
    leader->wait_for_workers();
    return leader;
  }

  void run_worker(const RankInfo& self) override {
    initialise(self);
    mpi::run_worker(self);
  }

  void refuse_work(const RankInfo& self, const std::string& why, int code) override {
    {
      const Watchdog watchdog(self.lost_after, code);
      initialise(self);
    }
    if (self.rank > 0) return mpi::refuse_work(self, why);
    Leader(self).wait_for_workers();
  }
};

}  // namespace
}  // namespace pupflow::mpi

extern "C" __attribute__((visibility("default"))) pupflow::mpi::Interface* pupflow_mpi_entry() {
  static pupflow::mpi::Module module;
  return &module;
}
