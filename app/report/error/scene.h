// Scenes with a reference solution, and the error of each method and setting against it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow::report {

/// For each quantity of a scene, the values at the sampled times.
using Trajectory = std::vector<std::vector<double>>;

/// One run.
struct Outcome {
  Trajectory samples;
  double seconds = 0;  // time of its steps on one core, for each model second
  Status status;       // bad when the run could not be finished
};

/// One way to compute a scene. Each scene defines what its routine numbers mean.
struct Setting {
  std::string label;
  Params params;
  int routine = 0;
};

/// Settings that differ in one thing, in the order of rising run time; a line in the plot.
struct Curve {
  std::string name;  // without commas
  std::vector<Setting> settings;
  bool refines = false;  // each setting halves the step of the one before it
};

/// Settings with a reference of their own; they get their own plot and table.
struct Aside {
  std::string name;   // of its files, after that of the scene
  std::string title;  // its heading
  std::string about;  // what is varied and what the reference is
  Setting reference;
  std::vector<Setting> settings;
  std::vector<std::size_t> quantities;  // of the scene: those that the settings change
};

struct Quantity {
  std::string name;  // a word, for columns
  std::string title;
  double size = 0;    // errors are divided by it; 0: by the root mean square of the reference
  bool drawn = true;  // has a panel in the plot
};

struct ErrorScene {
  std::string name;   // of its files
  std::string title;  // its heading
  std::string about;  // what happens and what the reference is: one or two paragraphs
  std::vector<Quantity> quantities;
  std::vector<Curve> curves;
  std::vector<Aside> asides;
  double smallest_drawn = 1e-6;    // lower end of the plot's errors
  Setting standard;                // the default: marked in table and plot
  bool standard_is_exact = false;  // the default is the closed form: in neither table nor plot
  Setting reference;               // computes the reference solution
  Setting finer;                   // half its step: shows that the reference has converged
  std::function<Outcome(const Setting&)> run;
  /// Replaces the reference's values of quantities that have a closed form; may be empty.
  std::function<void(Trajectory&)> closed_form;
};

/// One setting, measured.
struct Measured {
  Setting setting;
  double seconds = 0;
  Status status;
  std::vector<double> errors;  // one per quantity; NaN where the run could not be finished
  std::vector<double> orders;  // log2 of the last setting's error over this one's; NaN for the
                               // first, and where the curve does not refine
};

struct MeasuredCurve {
  std::string name;
  bool refines = false;
  std::vector<Measured> points;
};

struct SceneResult {
  std::vector<MeasuredCurve> curves;
  std::vector<std::vector<Measured>>
      asides;  // errors of all quantities against the aside's reference
  Measured standard;
  /// Largest relative change of the errors of the standard and of the refining curves' settings
  /// when the reference's step is halved, for each quantity.
  std::vector<double> reference_change;
  /// The difference of the two references as an error is measured; 0 for a closed form.
  std::vector<double> reference_difference;
};

/// Runs all settings, each a few times, and keeps the shortest time. Throws
/// io::Failure(interrupted).
SceneResult measure(const ErrorScene& scene, const Options& options);

/// Root mean square of `samples - reference` over the quantity's size, for each of `quantities`.
std::vector<double> errors_of(const Trajectory& samples, const Trajectory& reference,
                              const std::vector<Quantity>& quantities);

/// Adds the scene to the page: text, table, CSV file and plot.
void show(Report& report, const ErrorScene& scene, const SceneResult& result);

}  // namespace pupflow::report
