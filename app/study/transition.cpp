#include "app/study/transition.h"

#include <algorithm>
#include <cmath>

#include "app/io/celsius.h"
#include "app/io/text.h"

namespace pupflow::study {
namespace {

constexpr std::size_t kMeanTb = statistic_of(Observable::mean_tb),
                      kHuddling = statistic_of(Observable::huddling),
                      kFlow = statistic_of(Observable::flow);

double mean_of(const Summary& summary, std::size_t statistic) {
  return summary.statistics[statistic].mean;
}

Peak peak_of(const std::vector<Summary>& summaries, std::size_t index) {
  const Summary& highest = *std::max_element(
      summaries.begin(), summaries.end(),
      [&](const Summary& a, const Summary& b) { return mean_of(a, index) < mean_of(b, index); });
  return {highest.values[0], mean_of(highest, index)};
}

/// The part of the way from `a` to `b` on which a value that goes straight from `at_a` to `at_b` is
/// within kHeld of 0.
std::optional<Range> held_between(double a, double b, double at_a, double at_b) {
  double from = 0, to = 1;
  const double change = at_b - at_a;
  if (change == 0) {
    if (std::abs(at_a) > kHeld) return std::nullopt;
  } else {
    const double one = (-kHeld - at_a) / change, other = (kHeld - at_a) / change;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    if (!(from < to)) return std::nullopt;
  }
  return Range{from == 0 ? a : a + from * (b - a), to == 1 ? b : a + to * (b - a)};
}

/// A temperature as the summary of a sweep has it.
std::string ta_text(double ta, bool celsius) {
  return io::with_celsius(io::formatted("%.3f", ta), ta, celsius);
}

std::string held_text(const std::vector<Range>& held, bool celsius) {
  if (held.empty())
    return io::formatted("mean T_b is within %g of T_p at no T_a of this sweep\n", kHeld);
  std::string text = io::formatted("mean T_b is within %g of T_p over T_a ", kHeld);
  for (std::size_t i = 0; i < held.size(); ++i) {
    text += (i == 0 ? "" : ", ") + ta_text(held[i].from, celsius) + " to " +
            ta_text(held[i].to, celsius);
  }
  return text + "\n";
}

}  // namespace

namespace {

/// The points in rising order of an axis.
std::vector<const Summary*> in_rising_order(const std::vector<Summary>& summaries,
                                            std::size_t axis) {
  std::vector<const Summary*> rising;
  for (const Summary& summary : summaries) rising.push_back(&summary);
  std::stable_sort(rising.begin(), rising.end(), [&](const Summary* a, const Summary* b) {
    return a->values[axis] < b->values[axis];
  });
  return rising;
}

}  // namespace

std::vector<Range> held_ranges(const Design& design, const std::vector<Summary>& summaries,
                               std::size_t axis) {
  const std::vector<const Summary*> rising = in_rising_order(summaries, axis);
  std::vector<Range> ranges;
  for (std::size_t i = 1; i < rising.size(); ++i) {
    const Summary &a = *rising[i - 1], &b = *rising[i];
    if (a.runs == 0 || b.runs == 0) continue;
    const double tp = design.params_of(0).preferred_temperature;
    const auto range = held_between(a.values[axis], b.values[axis], mean_of(a, kMeanTb) - tp,
                                    mean_of(b, kMeanTb) - tp);
    if (!range) continue;
    if (!ranges.empty() && ranges.back().to == range->from) {
      ranges.back().to = range->to;
    } else {
      ranges.push_back(*range);
    }
  }
  return ranges;
}

std::optional<Transition> find_transition(const Design& design,
                                          const std::vector<Summary>& summaries) {
  if (design.axes.size() != 1 || design.axes[0].parameter->name != "ta") return std::nullopt;
  if (summaries.size() < 2) return std::nullopt;
  for (const Summary& s : summaries) {
    if (s.runs == 0) return std::nullopt;
  }
  Transition t{std::nullopt, peak_of(summaries, kExposedSd), peak_of(summaries, kFlow),
               held_ranges(design, summaries, 0)};
  double steepest = 0;
  const std::vector<const Summary*> rising = in_rising_order(summaries, 0);
  for (std::size_t i = 1; i < rising.size(); ++i) {
    const Summary &before = *rising[i - 1], &after = *rising[i];
    if (before.values[0] == after.values[0]) continue;
    const double slope = (mean_of(before, kHuddling) - mean_of(after, kHuddling)) /
                         (after.values[0] - before.values[0]);
    if (slope > steepest) {
      steepest = slope;
      t.steepest = Range{before.values[0], after.values[0]};
    }
  }
  return t;
}

std::string transition_text(const Design& design, const Transition& t, bool celsius) {
  const Params& base = design.base;
  std::string text = "1 - A does not fall";
  if (t.steepest) {
    text = "1 - A falls most steeply between T_a " + ta_text(t.steepest->from, celsius) + " and " +
           ta_text(t.steepest->to, celsius);
  }
  if (base.air_conductance > 0) {
    text +=
        "; T_p - G/k1 = " +
        ta_text(base.preferred_temperature - base.thermogenesis / base.air_conductance, celsius);
  }
  if (!std::isnan(t.exposed_sd.value)) {  // as it is of a single step
    text += io::formatted("\nthe standard deviation of A is highest, %.3g, at T_a ",
                          t.exposed_sd.value) +
            ta_text(t.exposed_sd.ta, celsius);
  }
  if (!std::isnan(t.flow.value)) {
    text += io::formatted("\npup flow (lag %lld) is highest, %.3g /s, at T_a ",
                          static_cast<long long>(base.flow_lag), t.flow.value) +
            ta_text(t.flow.ta, celsius);
  }
  text += "\n";
  return text + held_text(t.held, celsius);
}

}  // namespace pupflow::study
