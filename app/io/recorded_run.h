// Recordings, read back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/io/data_set.h"
#include "app/io/png.h"
#include "pupflow/parameters.h"

namespace pupflow::io {

class Hdf5Reader;

/// A recording of the present layout, open for reading. Its data sets have the sizes that its
/// parameters say. Members throw Failure: bad_file when the file cannot be read or is damaged,
/// bad_input when it is no such recording.
class RecordedRun {
 public:
  explicit RecordedRun(const std::string& path);
  ~RecordedRun();
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  const std::string& path() const { return path_; }
  const TextEntries& about() const { return about_; }
  const Params& params() const { return params_; }
  std::size_t frames() const { return steps_.size(); }
  const std::vector<std::int64_t>& steps() const { return steps_; }  // of the frames
  const std::vector<double>& times() const { return times_; }        // model seconds

  /// The recorded fields, and point/position where it is recorded: data sets (frame, pup, ...).
  const std::vector<SetInfo>& fields() const { return fields_; }

  /// The data set of the field called `name`, or of "position"; nullptr where it is not recorded.
  const SetInfo* find(const std::string& name) const;

  /// `count` frames of a field from frame `first` on, for all pups or for one.
  void read(const SetInfo& field, std::size_t first, std::size_t count, std::optional<int> pup,
            NumberType type, void* values) const;

  /// The sheet of the skin: its side in pixels, and the afferent at each, row by row.
  struct Sheet {
    std::size_t size;
    std::vector<int> afferent;
  };
  Sheet sheet() const;

 private:
  void check_sizes() const;
  [[noreturn]] void damaged(const std::string& what) const;

  std::string path_;
  std::unique_ptr<Hdf5Reader> file_;
  TextEntries about_;
  Params params_;
  std::vector<SetInfo> fields_;
  std::vector<std::int64_t> steps_;
  std::vector<double> times_;
};

}  // namespace pupflow::io
