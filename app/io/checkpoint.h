// Checkpoints: HDF5 files from which a run goes on bit for bit.
#pragma once

#include <string>

#include "app/io/png.h"
#include "pupflow/simulation.h"

namespace pupflow::io {

/// Writes the whole state of `litter` to `path`, whole or not at all. Throws Failure(bad_file).
void write_checkpoint(const std::string& path, bool force, const Simulation& litter);

/// Reads one back. That of a version before 0.2.0 does not tell what was changed on the way: it
/// counts as edited at its step. Throws Failure: bad_file when it cannot be read, bad_input when it
/// is no checkpoint.
Snapshot read_checkpoint(const std::string& path);

/// The text attributes of an HDF5 file of this program. Throws Failure(bad_file).
TextEntries read_hdf5_text(const std::string& path);

}  // namespace pupflow::io
