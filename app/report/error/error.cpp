#include "app/report/error/error.h"

#include <functional>

#include "app/report/error/litter.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/savings/savings.h"

namespace pupflow::report {
namespace {

void introduce(Report& report) {
  report.text(
      "How large is the error of a run, and how long does it take? Six scenes that are not chaotic "
      "and have a reference solution are computed with each method and setting that a user can "
      "choose. The litter is chaotic, so its means are compared. "
      "[Summary of the scenes](#summary-of-the-scenes) has the main numbers.");
  report.text(
      "**How to read it.** An error is the root mean square of the difference from the reference "
      "over the samples of a scene (every 0.02 s), divided by the root mean square of the "
      "reference (in scene 3, by the amplitude at first): 0.01 is one per cent. The number in "
      "brackets is the observed order of convergence, log₂ of the error of the row before over the "
      "error of this row: 1 means that half the step gives half the error. Times are the processor "
      "time of the steps alone on one core, the shortest of several runs. *Consistent* and *naive* "
      "are the values of `refinement`: with consistent refinement a smaller step moves the same "
      "body; with naive refinement α does not change with the step. At dt = 0.01 both are the "
      "default, so they share that point.");
}

using Wanted = std::function<bool(const Params&)>;

/// The errors of the first setting for which `wanted` is true, and its time over the default's.
std::string cell_of(const SceneResult& result, const Wanted& wanted) {
  for (const MeasuredCurve& curve : result.curves) {
    for (const Measured& point : curve.points) {
      if (!wanted(point.setting.params)) continue;
      std::string text;
      for (const double error : point.errors) {
        text += (text.empty() ? "" : ", ") + rounded(error, 2);
      }
      return text + " (" + rounded(point.seconds / result.standard.seconds, 2) + ")";
    }
  }
  return "";
}

/// A table of the choices that most users have, a row for each scene.
void sum_up(Report& report, const std::vector<std::pair<ErrorScene, SceneResult>>& scenes) {
  std::vector<io::Row> rows{
      {"scene", "errors of", "default", "dt = 0.02", "float", "consistent, dt = 0.01/4"}};
  const auto step_is = [](const Params& p, double dt, Refinement refinement) {
    return p.dt == dt && p.refinement == refinement && p.precision == Precision::double_ &&
           p.integrator == Integrator::predictive && p.heat == HeatRule::exact;
  };
  for (const auto& [scene, result] : scenes) {
    if (scene.standard_is_exact) continue;
    std::string names;
    for (const Quantity& q : scene.quantities) names += (names.empty() ? "" : ", ") + q.title;
    rows.push_back(
        {scene.title, names,
         cell_of(result,
                 [&standard = scene.standard.params](const Params& p) { return p == standard; }),
         cell_of(result, [&](const Params& p) { return step_is(p, 0.02, Refinement::naive); }),
         cell_of(result,
                 [&](const Params& p) { return p.dt == 0.01 && p.precision == Precision::float_; }),
         cell_of(result,
                 [&](const Params& p) { return step_is(p, 0.01 / 4, Refinement::consistent); })});
  }
  report.heading("Summary of the scenes");
  report.text(
      "Errors as above; in brackets the time over the default's time. For one or two pups twice "
      "the step takes half to two thirds of the time, with the errors of the column dt = 0.02. For "
      "a litter it saves less, and nothing in the cold, since softer pups touch more (section 7). "
      "The reference is the limit of fine steps of the same body, not an observation. The paper's "
      "model includes dt = 0.01, so its results are those of the default with these errors. Scene "
      "5 is not listed: its default has no error but rounding.");
  report.table(rows);
}

}  // namespace

void report_error(const Options& options) {
  Report report(options, "Error against run time");
  introduce(report);
  std::vector<std::pair<ErrorScene, SceneResult>> scenes;
  for (const auto make : kErrorScenes) {
    const ErrorScene scene = make(options.quick);
    const SceneResult result = measure(scene, options);
    show(report, scene, result);
    scenes.emplace_back(scene, result);
  }
  sum_up(report, scenes);
  litter_section(report);
  divergence_section(report);
  savings_section(report);
  report.finish();
}

}  // namespace pupflow::report
