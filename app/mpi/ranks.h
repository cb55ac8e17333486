// What the program asks of its MPI side: several processes, the ranks, work on one sweep. That side
// is a module of its own (pupflow_mpi), loaded only when mpirun or srun started this process, so
// that everything else starts fast and runs where no MPI is installed.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "app/study/crew.h"

namespace pupflow::mpi {

struct Membership {
  int rank = 0, size = 1;                       // as the launcher told this process
  int threads = 1;                              // that compute on this rank
  std::chrono::milliseconds lost_after{60000};  // a rank silent for so long is given up
  std::string job;  // what this rank was told to do; must be the same on all ranks
};

class Ranks {
 public:
  virtual ~Ranks() = default;

  /// On rank 0: the crew of all ranks, this one included. Its end sends the others home. Throws
  /// io::Failure(bad_input) when MPI sees other ranks than the launcher promised, or ranks differ
  /// in what they were told to do.
  virtual std::unique_ptr<study::Crew> lead(const Membership& self) = 0;

  /// On the others: computes what rank 0 hands out until it sends them home. Throws
  /// io::Failure(interrupted), and bad_input as above.
  virtual void serve(const Membership& self) = 0;
};

/// The one symbol that the module exports; the object lives as long as the module.
constexpr const char* kRanksEntry = "pupflow_mpi_entry";
using RanksEntry = Ranks* (*)();

}  // namespace pupflow::mpi
