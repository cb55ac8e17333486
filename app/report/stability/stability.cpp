#include "app/report/stability/stability.h"

#include "app/io/interrupt.h"
#include "app/report/share_out.h"
#include "app/report/stability/cells.h"
#include "app/report/stability/extreme/scenes.h"
#include "app/report/stability/figure.h"

namespace pupflow::report {
namespace {

/// A default litter, whose class must be stable.
struct DefaultLitter {
  std::string_view name;
  double ta;
};
constexpr DefaultLitter kDefaults[] = {{"cold", 0.2}, {"at the transition", 0.48}, {"warm", 0.8}};

std::vector<Trial> try_defaults(const Options& options) {
  std::vector<Trial> trials(std::size(kDefaults));
  share_out("the default litter", std::ssize(trials), options, [&](std::int64_t task) {
    const auto i = static_cast<std::size_t>(task);
    Params params;
    params.ambient_temperature = kDefaults[i].ta;
    const auto trial = try_litter(params, io::interrupted);
    if (trial) trials[i] = *trial;
  });
  return trials;
}

/// The classes, their limits, and the numbers of the default litter.
void classes_section(Report& report, const std::vector<Trial>& defaults) {
  report.heading("Classes");
  report.text(
      "The class of a run is the worst of these that applies. Numbers are from every step of its "
      "last quarter (overlap: every 25th). A pup's deformation energy is the mean over its points "
      "of |x − c − R q|²/r_pup², the squared distance from the rest shape at its best rotation; 1 "
      "is a displacement of all points by a radius. Its kinetic energy is the mean over its points "
      "of v²/2.");
  io::Row head{"class", "meaning", "limit"};
  for (const DefaultLitter& one : kDefaults) {
    head.push_back("default, " + std::string(one.name) + " (T_a = " + rounded(one.ta) + ")");
  }
  std::vector<io::Row> table{head};
  for (const Class& one : classes()) {
    const bool stable = &one == classes().data();
    io::Row row{std::string(one.name), std::string(one.meaning),
                one.measure != nullptr ? rounded(one.limit) : ""};
    for (const Trial& trial : defaults) {
      row.push_back(stable                   ? std::string(class_of(trial.verdict).name)
                    : one.measure != nullptr ? rounded(trial.*one.measure)
                                             : "");
    }
    table.push_back(row);
  }
  report.table(table);
  std::string energies, nearest;
  for (const Trial& trial : defaults) {
    energies += (energies.empty() ? "" : ", ") + rounded(trial.energy);
    nearest += (nearest.empty() ? "" : ", ") + rounded(trial.nearest);
  }
  report.text("The default litter is 12 pups for 1500 steps. Its mean deformation energy is " +
              energies + ", and the distance to the nearest other centre is " + nearest +
              " in units of 2 r_pup. Bodies in contact overlap in this model, since contacts move "
              "points by a small share of their overlap.");
}

/// The results of one scene in both precisions.
struct SceneFindings {
  Finding single, twice;
};

void scenes_section(Report& report, const std::vector<SceneFindings>& results) {
  report.heading("Extreme scenes");
  report.text(
      "Each scene has a test of the same name (`Extreme`). 'yes' means that the expected result "
      "occurred, in single and in double precision. Warnings of the engine are listed, also where "
      "a run ends fine.");
  std::vector<io::Row> table{{"scene", "expected", "float", "double", "result (double)"}};
  std::string single;
  const auto scenes = extreme_scenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const SceneFindings& result = results[i];
    table.push_back({std::string(scenes[i].scene), std::string(scenes[i].expected),
                     result.single.ok ? "yes" : "NO", result.twice.ok ? "yes" : "NO",
                     result.twice.happened});
    single += "- " + std::string(scenes[i].scene) + ": " + result.single.happened + "\n";
  }
  report.table(table);
  report.text("In single precision:");
  report.text(single);
}

std::vector<SceneFindings> run_scenes(const Options& options) {
  const auto scenes = extreme_scenes();
  std::vector<SceneFindings> results(scenes.size());
  share_out("extreme scenes", static_cast<std::int64_t>(2 * scenes.size()), options,
            [&](std::int64_t task) {
              // The last scenes take longest, so they begin first.
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
  classes_section(report, try_defaults(options));
  report.heading("Maps");
  const std::string steps = options.quick ? "500" : "1500";
  const std::string most = options.quick ? "1000" : "3000";
  report.text(
      "The default litter (T_a = 0.4) unless a map says otherwise, for " + steps +
      " steps, or 8 model seconds where that is more, " + most +
      " steps at most. Each cell stands for three litters, with seeds 1 to 3, and has the median "
      "of their classes in the order of the table. Where they differ, a dot has the color of the "
      "other class, the worse one of two. White cells are refused. Circle: the default. Black "
      "lines: theory.");
  for (const StabilityMap& map : stability_maps(options.quick)) {
    show_map(report, map, compute_map(map, options));
  }
  scenes_section(report, run_scenes(options));
  report.finish();
}

}  // namespace pupflow::report
