// Recordings: HDF5 files with the litter's state at chosen steps, for analysis elsewhere.
#pragma once

#include <memory>
#include <string>

#include "pupflow/parameters.h"
#include "pupflow/view.h"

namespace pupflow::io {

/// One recording being written; appears whole or not at all. Data sets, a row per frame: /step
/// (int64), /time, /point/position (float32: frame x pup x point x 3), and /pup/NAME (frame x pup)
/// for all pup fields that go into files (LitterField::in_files), with attributes unit and
/// description. Attributes of the file: io::provenance, kind and layout. Members throw
/// Failure(bad_file).
class Recording {
 public:
  Recording(const std::string& path, bool force, const Params& params);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Adds the state as it is now.
  void add(const LitterView& litter);

  /// Puts the file in its place, with `ending` (if not empty) as an attribute saying why it ends
  /// early.
  void commit(const std::string& ending);

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace pupflow::io
