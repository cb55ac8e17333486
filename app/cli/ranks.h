// The other processes of this job, where mpirun or srun started several.
#pragma once

#include "app/mpi/ranks.h"

namespace pupflow::cli {

/// Which of how many processes this is, told by the launcher's environment variables; rank 0 of 1
/// where there is no launcher. Throws io::Failure(bad_input) when PUPFLOW_LOST_AFTER, the silence
/// in seconds after which a rank is given up, is no such number.
mpi::Membership launched();

/// Whether the process is one that leaves speaking to rank 0: what the first of several ranks says
/// about the command line of a sweep, it says for all.
bool leaves_speaking(int argc, char** argv);

/// Loads the MPI module. Throws io::Failure(bad_input) when it was not built or a library that it
/// needs is missing: each of the processes would otherwise do the whole work.
mpi::Ranks& load_ranks(const mpi::Membership& self);

}  // namespace pupflow::cli
