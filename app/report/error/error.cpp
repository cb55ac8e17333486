#include "app/report/error/error.h"

#include <functional>

#include "app/report/error/litter.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/savings/savings.h"

namespace pupflow::report {
namespace {

void introduce(Report& report) {
  report.text(
      "How exact is a run, and what does it cost? Six scenes with a right answer, in which nothing "
      "is chaotic, are computed with each method and setting that a user can choose; then the "
      "litter, which is chaotic, by its means. [The scenes in short](#the-scenes-in-short) "
      "is the summary.");
  report.text(
      "**How to read it.** An error is the root mean square of the difference from the right "
      "answer over the samples of a scene (every 0.02 s), divided by the root mean square of the "
      "right answer (in scene 3, by the amplitude at first): 0.01 is one per cent. In brackets "
      "behind it stands the observed order of "
      "convergence, log₂ of the error of the row before over this one's: 1 means that half the "
      "step makes half the error. Times are those of the steps on one core, the shortest of "
      "several runs (processor time: wall time, less what other work on the machine takes). "
      "*Consistent* and *naive* are the values of `refinement`: with consistent refinement a "
      "smaller step moves the same body, with naive refinement α is taken as it is. At dt = 0.01 "
      "both are the default, so they share that point. Times are of the steps alone, whatever a "
      "scene does between them.");
}

using Wanted = std::function<bool(const Params&)>;

/// The errors of the first setting that is wanted, and its share of the default's time.
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

/// What each scene says about the choices that most users face.
void sum_up(Report& report, const std::vector<std::pair<Scene, SceneResult>>& scenes) {
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
         cell_of(result, [&](const Params& p) { return p == scene.standard.params; }),
         cell_of(result, [&](const Params& p) { return step_is(p, 0.02, Refinement::naive); }),
         cell_of(result,
                 [&](const Params& p) { return p.dt == 0.01 && p.precision == Precision::float_; }),
         cell_of(result,
                 [&](const Params& p) { return step_is(p, 0.01 / 4, Refinement::consistent); })});
  }
  report.heading("The scenes in short");
  report.text(
      "Errors as above, and in brackets the time in units of the default's. For these one or two "
      "pups twice the step takes half to two thirds of the time, and what that costs stands under "
      "dt = 0.02; for a litter it saves less, and in the cold nothing, since softer pups touch "
      "more (section 7). Note what the right answer is: not nature, but the limit of fine steps of "
      "the same body. The paper's "
      "model has dt = 0.01 in it, and its results are those of the default, errors included. "
      "Scene 5 is left out: its default has no error but rounding.");
  report.table(rows);
}

}  // namespace

void report_error(const Options& options) {
  Report report(options, "Error against run time");
  introduce(report);
  std::vector<std::pair<Scene, SceneResult>> scenes;
  for (const auto& make :
       {fall_scene, spin_scene, squeeze_scene, press_scene, cooling_scene, steering_scene}) {
    const Scene scene = make(options.quick);
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
