#include "app/report/error/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/io/failure.h"
#include "app/io/progress.h"

namespace pupflow::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The right answer as two references tell it, the second with half the step.
struct Answer {
  Trajectory at_reference, at_finer;
};

Trajectory finished(const Scene& scene, const Setting& setting) {
  stop_if_interrupted();
  const Outcome outcome = scene.run(setting);
  if (outcome.status.ok()) return outcome.samples;
  throw io::Failure(io::ExitCode::bad_numbers,
                    scene.name + ", the reference: " + outcome.status.message());
}

Answer answer_of(const Scene& scene) {
  Answer answer{finished(scene, scene.reference), finished(scene, scene.finer)};
  if (scene.closed_form) {
    scene.closed_form(answer.at_reference);
    scene.closed_form(answer.at_finer);
  }
  return answer;
}

/// A setting under measurement.
struct Trial {
  const Setting* setting;
  Outcome best;  // the run that took least time
  int runs = 0;
};

/// One run, or a few of a setting so cheap that a single one is mostly noise.
void take_turn(const Scene& scene, Trial& trial) {
  const double runs = trial.runs == 0 ? 1 : std::clamp(2e-3 / trial.best.seconds, 1.0, 10.0);
  for (int i = 0; i < static_cast<int>(runs); ++i) {
    stop_if_interrupted();
    if (trial.runs > 0 && !trial.best.status.ok()) return;
    Outcome outcome = scene.run(*trial.setting);
    if (trial.runs++ == 0 || outcome.seconds < trial.best.seconds) trial.best = std::move(outcome);
  }
}

/// The default, then all settings of all curves and asides, in order. They take turns, so that
/// other work on the machine does not slow one of them alone.
std::vector<Trial> run_all(const Scene& scene, const Options& options) {
  std::vector<Trial> trials{{&scene.standard, {}, 0}};
  for (const Curve& curve : scene.curves) {
    for (const Setting& setting : curve.settings) trials.push_back({&setting, {}, 0});
  }
  for (const Aside& aside : scene.asides) {
    for (const Setting& setting : aside.settings) trials.push_back({&setting, {}, 0});
  }
  const int repeats = options.quick ? 3 : 7;
  io::Progress progress(scene.name, static_cast<std::int64_t>(trials.size()) * repeats,
                        options.quiet);
  std::int64_t done = 0;
  for (int i = 0; i < repeats; ++i) {
    for (Trial& trial : trials) {
      take_turn(scene, trial);
      progress.update(++done);
    }
  }
  return trials;
}

Measured judged(const Scene& scene, const Trial& trial, const Trajectory& right) {
  Measured measured{*trial.setting, trial.best.seconds, trial.best.status, {}, {}};
  measured.orders.assign(right.size(), kNone);
  measured.errors = measured.orders;
  if (measured.status.ok())
    measured.errors = errors_of(trial.best.samples, right, scene.quantities);
  return measured;
}

/// Takes note of how much the errors change from one reference to the other.
void compare_references(const Scene& scene, const Answer& answer, const Trajectory& samples,
                        std::vector<double>& change) {
  const std::vector<double> one = errors_of(samples, answer.at_reference, scene.quantities);
  const std::vector<double> other = errors_of(samples, answer.at_finer, scene.quantities);
  for (std::size_t q = 0; q < change.size(); ++q) {
    if (other[q] > 0) change[q] = std::max(change[q], std::abs(one[q] / other[q] - 1));
  }
}

void add_orders(const Measured& before, Measured& now) {
  for (std::size_t q = 0; q < now.errors.size(); ++q) {
    now.orders[q] = std::log2(before.errors[q] / now.errors[q]);
  }
}

}  // namespace

std::vector<double> errors_of(const Trajectory& samples, const Trajectory& right,
                              const std::vector<Quantity>& quantities) {
  std::vector<double> errors;
  for (std::size_t q = 0; q < right.size(); ++q) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < right[q].size(); ++i) {
      difference += std::pow(samples[q][i] - right[q][i], 2);
      size += std::pow(quantities[q].size == 0 ? right[q][i] : quantities[q].size, 2);
    }
    errors.push_back(std::sqrt(difference / size));
  }
  return errors;
}

SceneResult measure(const Scene& scene, const Options& options) {
  const Answer answer = answer_of(scene);
  const std::vector<Trial> trials = run_all(scene, options);
  SceneResult result;
  result.reference_change.assign(scene.quantities.size(), 0);
  result.reference_difference = errors_of(answer.at_reference, answer.at_finer, scene.quantities);
  auto trial = trials.begin();
  result.standard = judged(scene, *trial, answer.at_finer);
  compare_references(scene, answer, trial->best.samples, result.reference_change);
  for (const Curve& curve : scene.curves) {
    MeasuredCurve measured{curve.name, curve.refines, {}};
    for (std::size_t i = 0; i < curve.settings.size(); ++i) {
      measured.points.push_back(judged(scene, *++trial, answer.at_finer));
      if (!curve.refines || !measured.points.back().status.ok()) continue;
      compare_references(scene, answer, trial->best.samples, result.reference_change);
      if (i > 0) add_orders(measured.points[i - 1], measured.points[i]);
    }
    result.curves.push_back(std::move(measured));
  }
  for (const Aside& aside : scene.asides) {
    const Trajectory right = finished(scene, aside.reference);
    result.asides.emplace_back();
    for (std::size_t i = 0; i < aside.settings.size(); ++i) {
      result.asides.back().push_back(judged(scene, *++trial, right));
    }
  }
  return result;
}

}  // namespace pupflow::report
