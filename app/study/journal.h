// The finished runs of an unfinished sweep. They survive Ctrl-C, a kill or a full disk.
#pragma once

#include <map>
#include <string>

#include "app/study/results.h"

namespace pupflow::study {

/// A file to which each run is added when it is finished, as "number,row" (Design::number_of), so it
/// stays valid when seeds are added. Members throw io::Failure(bad_file).
class Journal {
 public:
  /// Opens `path`, or makes it, and reads the runs that it holds. From the first line that is
  /// incomplete or damaged on, the file is cut off.
  Journal(const std::string& path, const Design& design);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Finished runs by index.
  const std::map<std::int64_t, Row>& rows() const { return rows_; }

  /// Adds one; it is in the file when this returns.
  void add(const Row& row);

 private:
  void read();
  std::string path_;
  const Design& design_;
  std::map<std::int64_t, Row> rows_;
  int descriptor_ = -1;
};

}  // namespace pupflow::study
