#include "app/window/panels/transport_plan.h"

#include <algorithm>
#include <cstddef>

namespace pupflow::window {
namespace {

constexpr float kLeastForAll = 40;  // em; narrower than that, some parts are in the menu

constexpr std::array<float, kTransportParts> kWidths{4.4f, 2, 2,  4.8f,  6.9f,  4.6f,
                                                     5,    9, 14, 10.6f, 10.6f, 7.6f};

bool in_menu(TransportPart part) {
  return part >= TransportPart::speed;
}

}  // namespace

bool TransportPlan::ends_row(TransportPart part) const {
  const int here = row_of(part);
  return std::count(row.begin() + static_cast<std::ptrdiff_t>(part) + 1, row.end(), here) == 0;
}

float transport_width(TransportPart part) {
  return kWidths[static_cast<std::size_t>(part)];
}

TransportPlan plan_transport(float width) {
  TransportPlan plan;
  plan.compact = width < kLeastForAll;
  plan.rows = 1;
  float used = 0;
  for (int i = 0; i < kTransportParts; ++i) {
    const auto part = static_cast<TransportPart>(i);
    int& row = plan.row[static_cast<std::size_t>(i)];
    row = -1;
    if (plan.compact ? in_menu(part) : part == TransportPart::more) continue;
    const float wanted = transport_width(part);
    const bool group = part == TransportPart::speed;  // settings stand in a row of their own
    if (used > 0 && (group || used + kTransportGap + wanted > width)) {
      ++plan.rows;
      used = 0;
    }
    used += (used > 0 ? kTransportGap : 0) + wanted;
    row = plan.rows - 1;
  }
  return plan;
}

}  // namespace pupflow::window
