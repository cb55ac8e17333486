// The finished runs of an unfinished sweep. They survive Ctrl-C, a kill or a full disk.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "app/study/results.h"

namespace pupflow::study {

/// A file to which each run is added when it is finished, as "number,row,checksum". The number
/// (Design::number_of) and the checksum stay the same when seeds are added. Members throw
/// io::Failure(bad_file).
class Journal {
 public:
  /// Opens `path`, or makes it, and reads the runs that it holds. Damaged rows, and those of other
  /// parameters, are removed from the file and counted; a last row without an end is no damage.
  /// Refuses what is no regular file.
  Journal(const std::string& path, const Design& design);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Finished runs by index.
  const std::map<std::int64_t, Row>& rows() const { return rows_; }

  /// Rows that were damaged.
  std::int64_t damaged() const { return damaged_; }

  /// Adds one; it is in the file when this returns.
  void add(const Row& row);

 private:
  void read();
  /// Takes the row of a line; false when it is damaged.
  bool take(std::string_view line);
  /// A line but for its end.
  std::string line_of(const Row& row) const;
  std::string path_;
  const Design& design_;
  std::uint64_t seed_;  // of the checksums; other parameters give another
  std::map<std::int64_t, Row> rows_;
  std::int64_t damaged_ = 0;
  int descriptor_ = -1;
};

}  // namespace pupflow::study
