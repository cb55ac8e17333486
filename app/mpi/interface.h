// The interface of the MPI module (pupflow_mpi), with which several processes (ranks) share a
// sweep. The program loads the module only when mpirun or srun started it, so it starts fast and
// runs where no MPI is installed.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "app/study/executor.h"

namespace pupflow::mpi {

/// What a process knows about itself when it starts.
struct RankInfo {
  int rank = 0, size = 1;               // from the launcher: this rank and the number of ranks
  int threads = 1;                      // that compute on this rank
  std::chrono::seconds lost_after{60};  // a rank that sends no message for longer is lost
  std::string command;                  // the command line; must be the same on all ranks
};

class Interface {
 public:
  virtual ~Interface() = default;

  /// For rank 0: an executor that uses all ranks, this one included. Its destructor stops the other
  /// ranks. Throws io::Failure(bad_input) if MPI disagrees with the launcher about rank or size, if
  /// the command lines of two ranks differ, or if a rank cannot take part.
  virtual std::unique_ptr<study::Executor> start_leader(const RankInfo& self) = 0;

  /// For every other rank: computes the runs that rank 0 assigns, and returns when rank 0 stops it.
  /// Throws io::Failure: interrupted after a signal or when rank 0 is lost, bad_input if MPI
  /// disagrees with the launcher.
  virtual void run_worker(const RankInfo& self) = 0;

  /// For a rank that cannot take part: ends the job. Rank 0 stops all others; any other rank tells
  /// rank 0 why, which throws that, and returns when rank 0 stops it. Ends the process with `code` if
  /// MPI cannot be initialised within lost_after: other ranks may have failed, too. Throws as
  /// start_leader.
  virtual void refuse_work(const RankInfo& self, const std::string& why, int code) = 0;
};

/// The only symbol that the module exports, and its type. The object lives as long as the module.
constexpr const char* kEntry = "pupflow_mpi_entry";
using Entry = Interface* (*)();

}  // namespace pupflow::mpi
