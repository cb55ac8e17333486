// Recordings: HDF5 files with a litter's fields at chosen steps, for analysis elsewhere.
// docs/recordings.md describes the layout.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/io/png.h"
#include "pupflow/fields.h"
#include "pupflow/view.h"

namespace pupflow::io {

/// The layout that this version writes; docs/recordings.md has the versions.
inline constexpr int kRecordingLayout = 2;

/// What is recorded of each frame.
struct RecordedFields {
  std::vector<const LitterField*> fields;
  bool positions = false;  // of all points

  /// What the steps of frames must record for them (Simulation::set_observed).
  PartSet parts() const;
};

/// Reads names joined by commas: "pup" and "afferent" for those fields that belong in recordings
/// (LitterField::in_recordings), "point" for positions, or any field of 'pupflow fields'. Throws
/// Failure(bad_input).
RecordedFields parse_recorded_fields(const std::string& names);

/// One recording being written; appears whole or not at all. Until then it can be read where it is
/// written aside (FILE.PROCESS.unfinished), with what was flushed: after 0.1 s, 0.2 s, 0.4 s ... and
/// then every 5 s. A second thread writes. Members throw Failure(bad_file).
class Recording {
 public:
  /// Writes all that does not change: attributes and skin. `about` is what the file tells of its
  /// making (io::provenance).
  Recording(const std::string& path, bool force, const Params& params, const TextEntries& about,
            const RecordedFields& fields);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// Adds the state as it is now.
  void add(const LitterView& litter);

  /// After the last frame: adds an attribute to the file, in place of one of that name.
  void note(const std::string& name, const std::string& value);

  /// Puts the file in its place, with `ending` (if not empty) as an attribute saying why it ends
  /// early.
  void commit(const std::string& ending);

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace pupflow::io
