// Scenes that have a right answer, and how far each way of computing them is from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow::report {

/// What a run shows: for each quantity of its scene, the values at the sampled times.
using Trajectory = std::vector<std::vector<double>>;

/// One run.
struct Outcome {
  Trajectory samples;
  double seconds = 0;  // time of its steps on one core, for each model second
  Status status;       // bad when the run could not be finished
};

/// One way of computing a scene. What a routine number means is the scene's business.
struct Setting {
  std::string label;
  Params params;
  int routine = 0;
};

/// Settings that differ in one thing, from cheap to dear; a line in the plot.
struct Curve {
  std::string name;  // without commas
  std::vector<Setting> settings;
  bool refines = false;  // each setting halves the step of the one before it
};

/// Settings with a right answer of their own, for a plot and a table of their own.
struct Aside {
  std::string name;   // of its files, after that of the scene
  std::string title;  // its heading
  std::string about;  // what is varied and what the right answer is
  Setting reference;  // what to measure against
  std::vector<Setting> settings;
  std::vector<std::size_t> quantities;  // which of the scene's: those that the settings change
};

struct Quantity {
  std::string name;  // a word, for columns
  std::string title;
  double size = 0;    // what errors are divided by; 0: the root mean square of the right answer
  bool drawn = true;  // has a panel in the plot
};

struct Scene {
  std::string name;   // of its files
  std::string title;  // its heading
  std::string about;  // what happens and what the right answer is: a paragraph or two
  std::vector<Quantity> quantities;
  std::vector<Curve> curves;
  std::vector<Aside> asides;
  double smallest_drawn = 1e-6;    // lower end of the plot's errors
  Setting standard;                // the default: marked in table and plot
  bool standard_is_exact = false;  // it computes the right answer itself: neither table nor plot
  Setting reference;               // what the right answer comes from
  Setting finer;                   // its step halved: shows that the reference has converged
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
  std::vector<std::vector<Measured>> asides;  // errors of all quantities against the aside's answer
  Measured standard;
  /// Largest relative change of the errors of the standard and of the refining curves' settings
  /// when the reference's step is halved, for each quantity.
  std::vector<double> reference_change;
  /// The difference of the two references as an error is measured; 0 for a closed form.
  std::vector<double> reference_difference;
};

/// Runs all settings, each a few times, and keeps the shortest time. Throws io::Failure
/// (interrupted).
SceneResult measure(const Scene& scene, const Options& options);

/// Root mean square of `samples - right` over the quantity's size, for each of `quantities`.
std::vector<double> errors_of(const Trajectory& samples, const Trajectory& right,
                              const std::vector<Quantity>& quantities);

/// Puts the scene on the page: words, table, CSV and plot.
void show(Report& report, const Scene& scene, const SceneResult& result);

}  // namespace pupflow::report
