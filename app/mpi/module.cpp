// The MPI module: what the program loads when mpirun or srun started it.
#include <mpi.h>

#include <algorithm>
#include <array>

#include "app/io/failure.h"
#include "app/mpi/leader.h"
#include "app/mpi/worker.h"

namespace pupflow::mpi {
namespace {

/// "Open MPI v4.1.4" of a longer text.
std::string library_name() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string whole(text.data(), static_cast<std::size_t>(length));
  return whole.substr(0, whole.find_first_of(",\n"));
}

/// Joins the other ranks. A launcher and an MPI that do not know each other leave every process
/// alone, and each would do the whole sweep.
void join(const Membership& self) {
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

class Module final : public Ranks {
 public:
  std::unique_ptr<study::Crew> lead(const Membership& self) override {
    join(self);
    auto leader = std::make_unique<Leader>(self);
    leader->muster();
    return leader;
  }

  void serve(const Membership& self) override {
    join(self);
    work_for_leader(self);
  }
};

}  // namespace
}  // namespace pupflow::mpi

extern "C" __attribute__((visibility("default"))) pupflow::mpi::Ranks* pupflow_mpi_entry() {
  static pupflow::mpi::Module module;
  return &module;
}
