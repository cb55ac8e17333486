#include "app/window/panels/legend_plan.h"

#include <algorithm>

#include "app/view/colormap.h"

namespace pupflow::window {
namespace {

constexpr float kTicks = 5, kWheel = 7.5f, kSwatch = 1.3f;  // em
constexpr float kTallBar = 20, kTallSwatch = 1.9f;

float swatches(const view::ColorScale& scale) {
  const std::size_t named = scale.field->categories.size();
  return static_cast<float>(named > 0 ? named : view::kCategoryColors);
}

}  // namespace

LegendPlan plan_legend(const LegendStrip& strip) {
  LegendPlan plan;
  float left = strip.height;
  const auto take = [&](int rows) {
    const float height = static_cast<float>(rows) * strip.row;
    if (rows == 0 || left - height < strip.least_bar * strip.em) return false;
    left -= height;
    return true;
  };
  plan.field = take(1);
  plan.button = plan.field && take(1);
  plan.ends = plan.button && strip.has_ends && take(2);
  plan.lists = plan.button && (plan.ends || !strip.has_ends) && take(strip.maps);
  if (plan.button && (plan.lists || strip.maps == 0) && take(strip.section - 1)) {
    plan.section = true;
    plan.button = false;
  }
  plan.bar = std::min(left, strip.usual * strip.em);
  return plan;
}

float least_bar(const view::ColorScale& scale) {
  if (scale.categorical()) return kSwatch * swatches(scale);
  return scale.field->kind == FieldKind::angle ? kWheel : kTicks;
}

float usual_bar(const view::ColorScale& scale) {
  if (scale.categorical()) return kTallSwatch * swatches(scale);
  return scale.field->kind == FieldKind::angle ? kWheel : kTallBar;
}

}  // namespace pupflow::window
