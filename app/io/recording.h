// Recordings: HDF5 files with the litter's state at chosen steps, for analysis elsewhere.
#pragma once

#include <memory>
#include <string>

#include "pupflow/parameters.h"
#include "pupflow/simulation.h"

namespace pupflow::io {

/// One recording being written; appears whole or not at all. Datasets, a row per frame:
/// step (int64), time, position (float32: frame x pup x point x 3), body_temperature, exposed and
/// heading (frame x pup). Attributes: io::provenance. Members throw Failure(bad_file).
class Recording {
 public:
  Recording(const std::string& path, bool force, const Params& params);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Adds the state as it is now.
  void add(const Simulation& simulation);

  /// Puts the file in its place, with `ending` (if not empty) as an attribute saying why it ends
  /// early.
  void commit(const std::string& ending);

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace pupflow::io
