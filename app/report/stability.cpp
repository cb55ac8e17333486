#include "app/report/stability.h"

#include <stdexcept>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/report/share_out.h"
#include "app/report/stability_maps.h"
#include "app/report/stability_scenes.h"

namespace pupflow::report {
namespace {

std::string over(double threshold) {
  return "over " + rounded(threshold);
}

/// The six classes, their thresholds, and where the ordinary litter lies.
void classes_section(Report& report, const Trial& ordinary) {
  report.heading("Classes");
  report.text(
      "Each cell of a map is one run, called by the worst of these in its last quarter, where "
      "every step is looked at. A pup's deformation energy is the mean over its points of |x − c − "
      "R q|²/r_pup², its squared distance from the turned rest shape; 1 is a displacement of all "
      "points by a radius.");
  report.table(
      {{"class", "what it means", "threshold", "the paper's litter"},
       {"stable", "none of the below", "", std::string(verdict_name(ordinary.verdict))},
       {"ringing",
        "deformation energy does not settle: its standard deviation in time, mean over pups",
        over(kRingingSwing), rounded(ordinary.swing)},
       {"interpenetrating", "nearest centres over 2 r_pup, mean in time",
        "under " + rounded(kOverlap), rounded(ordinary.nearest)},
       {"inverted", "share of looks at pups whose fitted linear map has a negative determinant",
        over(kInvertedShare), rounded(ordinary.inverted)},
       {"escaped", "at the end, or when the step says so, all of a pup is beyond the wall", "any",
        "-"},
       {"diverged", "a step's status: not finite, or out of all proportion", "any", "-"}});
  report.text(
      "The paper's litter is that of the default parameters: 12 pups, 1500 steps; its mean "
      "deformation energy is " +
      rounded(ordinary.energy) +
      ". Bodies in contact overlap in this model, whose contacts move points by a small share of "
      "their overlap, so neighbours at half a diameter are ordinary.");
}

/// What every scene came to, in both precisions.
struct SceneResult {
  Finding single, twice;
};

void scenes_section(Report& report, const std::vector<SceneResult>& results) {
  report.heading("Extreme scenes");
  report.text(
      "Each has a test of the same name (`Extreme`). 'yes' is what should happen, in single and in "
      "double precision.");
  std::vector<io::Row> table{
      {"scene", "what should happen", "float", "double", "what happened (double)"}};
  std::string single;
  const auto scenes = extreme_scenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const SceneResult& result = results[i];
    table.push_back({std::string(scenes[i].scene), std::string(scenes[i].expected),
                     result.single.ok ? "yes" : "NO", result.twice.ok ? "yes" : "NO",
                     result.twice.happened});
    single += "- " + std::string(scenes[i].scene) + ": " + result.single.happened + "\n";
  }
  report.table(table);
  report.text("In single precision:");
  report.text(single);
}

std::vector<SceneResult> run_scenes(const Options& options) {
  const auto scenes = extreme_scenes();
  std::vector<SceneResult> results(scenes.size());
  share_out("extreme scenes", static_cast<std::int64_t>(2 * scenes.size()), options,
            [&](std::int64_t task) {
              // The last ones are the longest: first.
              const std::size_t i = scenes.size() - 1 - static_cast<std::size_t>(task / 2);
              const bool single = task % 2 == 0;
              const Precision precision = single ? Precision::float_ : Precision::double_;
              (single ? results[i].single : results[i].twice) =
                  scenes[i].run(precision, options.quick);
            });
  return results;
}

}  // namespace

void report_stability(const Options& options) {
  Report report(options, "Where the method is stable");
  const auto ordinary = try_litter(Params{}, io::interrupted);
  stop_if_interrupted();
  classes_section(report, *ordinary);
  report.heading("Maps");
  report.text("Six pups of the default litter unless a map says otherwise, for " +
              std::string(options.quick ? "800" : "1500") +
              " steps, or 8 model seconds where that is more, 4000 steps at most. Each cell is one "
              "litter of one seed, so a lone cell of another class says little, and a patch of "
              "them much. The circle is the default; red lines are theory.");
  for (const StabilityMap& map : stability_maps(options.quick)) {
    show_map(report, map, compute_map(map, options));
  }
  scenes_section(report, run_scenes(options));
  report.finish();
}

}  // namespace pupflow::report
