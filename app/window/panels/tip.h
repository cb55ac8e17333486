// Tooltips: when they open, and where.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/window/panels/layout.h"

namespace pupflow::window {

/// The tooltips of one window. A tip opens when the mouse has rested on an item for kRest seconds
/// with no button down. A press keeps it away until the mouse has left the item. A tip covers
/// neither the arena nor the item that it is about.
class Tips {
 public:
  static constexpr double kRest = 0.5;  // seconds

  /// A frame of that layout begins at `now` (seconds).
  void begin_frame(const Layout& layout, double now);

  /// Opens the tip of the item just submitted if it is time; then submit its content, and call
  /// `end`. Text wraps. Otherwise returns false.
  bool begin();
  void end();

  /// A tip of only text.
  void show(std::string_view text);

  /// Where the tip of this frame is; nothing: there is none.
  std::optional<Area> shown() const { return shown_; }

  /// When the next frame is needed for a tip, if nothing else happens before; nothing: never.
  std::optional<double> due() const { return due_; }

 private:
  bool rests_here();

  std::vector<Area> areas_;  // where a tip may stand
  double now_ = 0;
  std::optional<Area> item_;  // that the mouse is on
  bool seen_ = false;         // it was submitted in this frame
  bool pressed_ = false;      // a button went down on it
  bool open_ = false;
  double resting_since_ = 0;
  ImVec2 size_{0, 0};  // of the tip in the last frame; 0 before its first one
  std::optional<Area> shown_;
  std::optional<double> due_;
};

/// Where a tip of `size` stands: in one of `areas`, as near as can be to `item` and not over it.
/// Nothing: it fits nowhere.
std::optional<ImVec2> tip_place(const Area& item, ImVec2 size, std::span<const Area> areas,
                                float gap);

}  // namespace pupflow::window
