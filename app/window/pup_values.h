// What the fields say of a single pup, now and in the recent past.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/window/session/session.h"
#include "pupflow/fields.h"

namespace pupflow::window {

/// The values of `field` for one pup: one, or one for each of its afferents. The same numbers as
/// `field.values` has for it, without the work for all others where the field allows that. NaN where
/// the view lacks what the field reads.
std::vector<double> values_of(const LitterField& field, const LitterView& litter, int pup);

/// Pups that a pup touched in the last step, with how many of its points; by number. Empty unless
/// Part::owners and Part::pairs were recorded.
struct Touch {
  int pup, points;
};
std::vector<Touch> touched_by(const LitterView& litter, int pup);

/// All fields of one pup since it is watched. At most kSamples snapshots are kept; then every other
/// one goes, and those to come lie as far apart.
class PupCurves {
 public:
  static constexpr std::size_t kSamples = 600;
  struct Sample {
    std::int64_t step;
    double time;
    std::vector<double> values;  // of pup_fields(), in their order
  };

  /// Adds the pup as it is now. Another pup begins anew; what came later in a run that was gone back
  /// in is forgotten. The last sample is always of `litter`.
  void add(const LitterView& litter, int pup);

  const std::vector<Sample>& samples() const { return samples_; }

 private:
  void thin_out();

  std::optional<int> pup_;
  std::int64_t gap_ = 1;  // steps between samples, at least, but for the last one
  std::vector<Sample> samples_;
};

/// What steps must record for all fields of pups, and for `map`, a field of the afferents.
Watch recorded_for(const LitterField& map);

}  // namespace pupflow::window
