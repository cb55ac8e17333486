// What may be drawn over a litter, once: `overlays()`. Each overlay turns a litter into marks, in a
// file of its own in overlays/. Options, help and docs read the table.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/view/color_scale.h"
#include "app/view/marks.h"
#include "pupflow/plan.h"
#include "pupflow/view.h"

namespace pupflow::view {

/// Where the pups were; for trails. Memory is bounded by their length.
class Trails {
 public:
  explicit Trails(double seconds = 0) : seconds_(seconds) {}

  /// Adds the litter as it is now and forgets what is older than the trails are long. Starts anew
  /// for another number of pups and when time went back.
  void add(const LitterView& litter);

  /// The places of a pup, oldest first.
  std::vector<Eigen::Vector3d> of(std::size_t pup) const;
  double seconds() const { return seconds_; }

 private:
  struct Moment {
    double time;
    std::vector<Eigen::Vector3f> centres;
  };
  double seconds_;
  std::deque<Moment> moments_;
};

/// What an overlay reads.
struct OverlayScene {
  const LitterView& litter;
  const ColorScale& scale;  // fitted
  std::vector<Eigen::Vector3d> centres;
  const Trails& trails;
};

struct Overlay {
  std::string_view name;  // as typed
  std::string_view doc;   // a few words for help
  PartSet parts;          // what the step must record for it
  void (*draw)(const OverlayScene& scene, Marks& marks);
};

/// All overlays, in the order in which they are painted.
std::span<const Overlay> overlays();

/// A set of overlays. A plain value.
class OverlaySet {
 public:
  /// Names joined by commas; an empty text is the empty set. Throws Failure(bad_input) for a name
  /// that is none, with the nearest one or all.
  static OverlaySet parse(std::string_view names);

  /// The names, joined by commas.
  std::string names() const;

  bool empty() const { return bits_ == 0; }
  bool has(std::string_view name) const;
  void set(std::string_view name, bool on);  // of one in the table
  PartSet parts() const;

  /// Adds the marks of all its overlays.
  void draw(const OverlayScene& scene, Marks& marks) const;

  friend bool operator==(const OverlaySet&, const OverlaySet&) = default;

 private:
  std::uint32_t bits_ = 0;
};

// The entries of the table; each in overlays/NAME.cpp.
void draw_contacts(const OverlayScene& scene, Marks& marks);
void draw_headings(const OverlayScene& scene, Marks& marks);
void draw_groups(const OverlayScene& scene, Marks& marks);
void draw_trails(const OverlayScene& scene, Marks& marks);
void draw_ids(const OverlayScene& scene, Marks& marks);
void draw_forces(const OverlayScene& scene, Marks& marks);

}  // namespace pupflow::view
