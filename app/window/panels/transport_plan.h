// Which part of the transport stands in which row.
#pragma once

#include <array>

namespace pupflow::window {

/// In their order. Those from `speed` on move into a menu of their own, `more`, where the window is
/// narrow.
enum class TransportPart {
  play,
  step_back,
  step,
  restart,
  picture,
  record,
  more,
  clock,
  speed,
  as_fast,
  seed,
  compare
};
constexpr int kTransportParts = static_cast<int>(TransportPart::compare) + 1;

/// Lengths in multiples of the text size.
struct TransportPlan {
  std::array<int, kTransportParts> row{};  // of each part; -1: it is not there
  int rows = 0;
  bool compact = false;  // the last parts are in the menu

  int row_of(TransportPart part) const { return row[static_cast<std::size_t>(part)]; }
  bool ends_row(TransportPart part) const;
};

/// The width of a part, in multiples of the text size; the last one of a row takes what is left.
float transport_width(TransportPart part);

/// The plan for rows of that width, with gaps of kTransportGap between parts.
constexpr float kTransportGap = 0.5f;
TransportPlan plan_transport(float width);

/// Height of the timeline above the rows, in multiples of the text size.
constexpr float kStripHeight = 3.1f;

}  // namespace pupflow::window
