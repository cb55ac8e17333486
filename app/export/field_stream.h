// One field of a recording, frame by frame.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/export/export.h"

namespace pupflow::exporting {

/// A field, of all pups or of one, its afferents in their order or as images of the skin.
class FieldStream {
 public:
  /// The field that `request` names; without a name the first of `usual` that is recorded. Throws
  /// Failure(bad_input) when it is not recorded, or has no afferents for a sheet.
  FieldStream(const io::RecordedRun& recording, const Request& request,
              const std::vector<std::string>& usual, bool sheet);

  const io::SetInfo& field() const { return *field_; }

  /// The type of its numbers in the recording.
  io::NumberType type() const { return *io::number_type(field_->type); }

  /// Of a frame: (pup, ...), without pup where one is chosen.
  const std::vector<std::size_t>& shape() const { return shape_; }

  /// Numbers of a frame.
  std::size_t size() const;

  /// Calls `use(frame, numbers)` for each frame in order, with its numbers as bytes of `type`. Ends
  /// early, with Failure(interrupted), after Ctrl-C.
  using Use = std::function<void(std::size_t frame, std::span<const std::byte> numbers)>;
  void for_each_frame(io::NumberType type, io::Progress& progress, const Use& use) const;

 private:
  const io::RecordedRun& recording_;
  std::optional<int> pup_;
  const io::SetInfo* field_;
  std::vector<std::size_t> shape_;
  std::vector<int> sheet_;     // empty: none
  std::size_t in_file_ = 1;    // numbers of a frame as recorded
  std::size_t afferents_ = 0;  // of a pup
};

}  // namespace pupflow::exporting
