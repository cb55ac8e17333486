// A rank other than 0: computes what rank 0 hands out.
#pragma once

#include "app/mpi/ranks.h"

namespace pupflow::mpi {

/// Returns when rank 0 sent this rank home. Throws io::Failure(interrupted) after a signal, or when
/// rank 0 has been silent for too long.
void work_for_leader(const Membership& self);

}  // namespace pupflow::mpi
