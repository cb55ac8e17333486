#include "app/study/transition.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pupflow::study {
namespace {

constexpr double kWarm = 0.6;  // from here on the litter has dispersed
enum Index { kHuddling = 1, kFlow = 4 };

}  // namespace

std::optional<Transition> find_transition(const Design& design,
                                          const std::vector<Summary>& summaries) {
  if (design.axes.size() != 1 || design.axes[0].parameter->name != "ta") return std::nullopt;
  if (summaries.size() < 2 ||
      !std::is_sorted(design.axes[0].values.begin(), design.axes[0].values.end())) {
    return std::nullopt;
  }
  for (const Summary& s : summaries) {
    if (s.runs == 0) return std::nullopt;
  }
  Transition t{0, 0, 0, -1, {}};
  double steepest = 0, warm = 0;
  int warm_count = 0;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const double ta = summaries[i].values[0], flow = summaries[i].observables[kFlow].mean;
    if (flow > t.flow_peak) {
      t.flow_peak = flow;
      t.flow_peak_ta = ta;
    }
    if (ta >= kWarm) {
      warm += flow;
      ++warm_count;
    }
    if (i == 0) continue;
    const Summary& before = summaries[i - 1];
    const double slope =
        (before.observables[kHuddling].mean - summaries[i].observables[kHuddling].mean) /
        (ta - before.values[0]);
    if (slope > steepest || i == 1) {
      steepest = slope;
      t.steepest_from = before.values[0];
      t.steepest_to = ta;
    }
  }
  if (warm_count > 0) t.warm_flow = warm / warm_count;
  return t;
}

std::string transition_text(const Design& design, const Transition& t) {
  char line[256];
  std::snprintf(line, sizeof line, "1 - A falls most steeply between T_a %.4g and %.4g",
                t.steepest_from, t.steepest_to);
  std::string text = line;
  if (design.base.k1 > 0) {
    std::snprintf(line, sizeof line, "; T_p - G/k1 = %.4g",
                  design.base.tp - design.base.g / design.base.k1);
    text += line;
  }
  text += "\n";
  std::snprintf(line, sizeof line, "pup flow is highest, %.4g /s, at T_a %.4g", t.flow_peak,
                t.flow_peak_ta);
  text += line;
  if (t.warm_flow && *t.warm_flow > 0) {
    std::snprintf(line, sizeof line, ": %.3g times its mean over T_a >= 0.6",
                  t.flow_peak / *t.warm_flow);
    text += line;
  }
  return text + "\n";
}

}  // namespace pupflow::study
