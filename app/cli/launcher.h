// Several processes (ranks) that mpirun or srun started for one job.
#pragma once

#include "app/io/failure.h"
#include "app/mpi/interface.h"

namespace pupflow::cli {

/// This process's rank and the number of ranks, from the launcher's environment variables; rank 0
/// of 1 if there are none. `threads` stays at its default. Throws io::Failure(bad_input) if
/// PUPFLOW_LOST_AFTER is not a whole number of seconds from 1.
mpi::RankInfo launched_rank();

/// Whether this process prints no errors: in a sweep over several ranks all ranks find the same
/// errors in the command line, and only rank 0 prints them.
bool is_silent_rank(int argc, char** argv);

/// Ends a job of several ranks that this rank cannot take part in because its sweep does not begin:
/// rank 0 learns why from the others, which are silent. Does nothing after load_mpi, or where there
/// is no such job.
void leave_job(int argc, char** argv, const std::string& why, io::ExitCode code) noexcept;

/// Loads the MPI module. Throws io::Failure(bad_input) if it was not built or a library that it
/// needs is missing: each process would compute the whole sweep.
mpi::Interface& load_mpi(const mpi::RankInfo& self);

}  // namespace pupflow::cli
