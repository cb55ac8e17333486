#include "app/report/error/changes.h"

#include <algorithm>
#include <cmath>

#include "app/report/report.h"

namespace pupflow::report {
namespace {

/// Adds changes to a list, one group after the other.
class Changes {
 public:
  explicit Changes(const Params& base) : base_(base) { list_.push_back({"", "unchanged", base}); }

  template <class Edit>
  void add(const std::string& group, const std::string& label, Edit edit) {
    Change change{group, label, base_};
    edit(change.params);
    list_.push_back(std::move(change));
  }

  /// Another step for the same model seconds.
  void add_step(Refinement refinement, double factor) {
    const double dt = factor * base_.dt;
    // At the reference step both kinds of refinement are one model.
    if (refinement != base_.refinement && dt == kReferenceStep) return;
    const bool naive = refinement == Refinement::naive;
    add("time step", "dt = " + rounded(dt, 6) + (naive ? ", naive" : ", consistent"),
        [&](Params& p) {
          p.dt = dt;
          p.refinement = refinement;
          p.steps = std::llround(static_cast<double>(p.steps) / factor);
          p.discard = std::llround(static_cast<double>(p.discard) / factor);
        });
  }

  void add_window(const std::string& group, std::int64_t discard, std::int64_t steps) {
    const std::string last = std::to_string(steps);
    const std::string words =
        discard < steps ? "steps " + std::to_string(discard + 1) + " to " + last : last + " steps";
    add(group, words, [&](Params& p) { p.discard = discard, p.steps = steps; });
  }

  std::vector<Change> list_;

 private:
  Params base_;
};

/// The other of two values.
template <class Choice>
Choice other(Choice now, Choice one, Choice two) {
  return now == one ? two : one;
}

std::string named(const char* name, const Params& params) {
  return format_value(*find_parameter(name), params);
}

}  // namespace

std::vector<Change> changes_of(const Params& base, int longest) {
  Changes changes(base);
  const bool naive = base.refinement == Refinement::naive;
  for (const double factor : {2.0, 0.5}) changes.add_step(base.refinement, factor);
  if (naive) changes.add_step(Refinement::consistent, 0.5);
  changes.add_step(Refinement::consistent, 0.25);
  if (!naive) changes.add_step(Refinement::naive, 1);
  const int few = std::max(1, 2 * base.face_points / 7);
  for (const int k : {base.face_points - few, base.face_points + few}) {
    changes.add("points", "k = " + std::to_string(k), [&](Params& p) { p.face_points = k; });
  }
  const auto add_choice = [&](const char* name, auto edit) {
    Params edited = base;
    edit(edited);
    changes.add(name, named(name, edited), edit);
  };
  add_choice("precision", [](Params& p) {
    p.precision = other(p.precision, Precision::float_, Precision::double_);
  });
  add_choice("integrator", [](Params& p) {
    p.integrator = other(p.integrator, Integrator::predictive, Integrator::explicit_);
  });
  add_choice("heat", [](Params& p) { p.heat = other(p.heat, HeatRule::exact, HeatRule::euler); });
  const std::int64_t begin = base.discard, end = base.steps, length = end - begin;
  changes.add_window("run length", begin, end / 2);
  for (int times = 2; times <= longest; times *= 2) {
    changes.add_window("run length", begin, times * end);
  }
  if (begin > 0) changes.add_window("window", begin / 2, end);
  changes.add_window("window", end - length / 2, end);
  changes.add_window("window", end, end + length);
  if (longest > 2) changes.add_window("window", longest * end / 2, longest * end);
  return changes.list_;
}

}  // namespace pupflow::report
