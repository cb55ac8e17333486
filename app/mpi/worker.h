// A rank other than 0: computes the runs that rank 0 assigns.
#pragma once

#include "app/mpi/interface.h"

namespace pupflow::mpi {

/// Returns when rank 0 has stopped this rank. Throws io::Failure(interrupted) after a signal or
/// when rank 0 is lost.
void run_worker(const RankInfo& self);

/// The same for a rank that cannot take part; `why` is told to rank 0.
void refuse_work(const RankInfo& self, const std::string& why);

}  // namespace pupflow::mpi
