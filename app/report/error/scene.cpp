#include "app/report/error/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/io/failure.h"
#include "app/io/progress.h"

namespace pupflow::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The reference solution with its step, and with half of it.
struct References {
  Trajectory given, finer;
};

Trajectory finished(const ErrorScene& scene, const Setting& setting) {
  stop_if_interrupted();
  const Outcome outcome = scene.run(setting);
  if (outcome.status.ok()) return outcome.samples;
  throw io::Failure(io::ExitCode::bad_numbers,
                    scene.name + ", reference: " + outcome.status.message());
}

References references_of(const ErrorScene& scene) {
  References references{finished(scene, scene.reference), finished(scene, scene.finer)};
  if (scene.closed_form) {
    scene.closed_form(references.given);
    scene.closed_form(references.finer);
  }
  return references;
}

/// A setting and its fastest run so far.
struct TimedSetting {
  const Setting* setting;
  Outcome best;  // the run that took least time
  int runs = 0;
};

/// One run, or a few where one is too short to be timed.
void take_turn(const ErrorScene& scene, TimedSetting& timed) {
  const double runs = timed.runs == 0 ? 1 : std::clamp(2e-3 / timed.best.seconds, 1.0, 10.0);
  for (int i = 0; i < static_cast<int>(runs); ++i) {
    stop_if_interrupted();
    if (timed.runs > 0 && !timed.best.status.ok()) return;
    Outcome outcome = scene.run(*timed.setting);
    if (timed.runs++ == 0 || outcome.seconds < timed.best.seconds) timed.best = std::move(outcome);
  }
}

/// The default, then all settings of all curves and asides, in order. They take turns, so that
/// other work on the machine does not slow one of them alone.
std::vector<TimedSetting> run_all(const ErrorScene& scene, const Options& options) {
  std::vector<TimedSetting> all{{&scene.standard, {}, 0}};
  for (const Curve& curve : scene.curves) {
    for (const Setting& setting : curve.settings) all.push_back({&setting, {}, 0});
  }
  for (const Aside& aside : scene.asides) {
    for (const Setting& setting : aside.settings) all.push_back({&setting, {}, 0});
  }
  const int repeats = options.quick ? 3 : 7;
  io::Progress progress(scene.name, static_cast<std::int64_t>(all.size()) * repeats, options.quiet);
  std::int64_t done = 0;
  for (int i = 0; i < repeats; ++i) {
    for (TimedSetting& timed : all) {
      take_turn(scene, timed);
      progress.update(++done);
    }
  }
  return all;
}

Measured judged(const ErrorScene& scene, const TimedSetting& timed, const Trajectory& reference) {
  Measured measured{*timed.setting, timed.best.seconds, timed.best.status, {}, {}};
  measured.orders.assign(reference.size(), kNone);
  measured.errors = measured.orders;
  if (measured.status.ok())
    measured.errors = errors_of(timed.best.samples, reference, scene.quantities);
  return measured;
}

/// Raises `change` to the relative change of the errors from one reference to the other.
void compare_references(const ErrorScene& scene, const References& references,
                        const Trajectory& samples, std::vector<double>& change) {
  const std::vector<double> one = errors_of(samples, references.given, scene.quantities);
  const std::vector<double> other = errors_of(samples, references.finer, scene.quantities);
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

std::vector<double> errors_of(const Trajectory& samples, const Trajectory& reference,
                              const std::vector<Quantity>& quantities) {
  std::vector<double> errors;
  for (std::size_t q = 0; q < reference.size(); ++q) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < reference[q].size(); ++i) {
      difference += std::pow(samples[q][i] - reference[q][i], 2);
      size += std::pow(quantities[q].size == 0 ? reference[q][i] : quantities[q].size, 2);
    }
    errors.push_back(std::sqrt(difference / size));
  }
  return errors;
}

SceneResult measure(const ErrorScene& scene, const Options& options) {
  const References references = references_of(scene);
  const std::vector<TimedSetting> all = run_all(scene, options);
  SceneResult result;
  result.reference_change.assign(scene.quantities.size(), 0);
  result.reference_difference = errors_of(references.given, references.finer, scene.quantities);
  auto timed = all.begin();
  result.standard = judged(scene, *timed, references.finer);
  compare_references(scene, references, timed->best.samples, result.reference_change);
  for (const Curve& curve : scene.curves) {
    MeasuredCurve measured{curve.name, curve.refines, {}};
    for (std::size_t i = 0; i < curve.settings.size(); ++i) {
      measured.points.push_back(judged(scene, *++timed, references.finer));
      if (!curve.refines || !measured.points.back().status.ok()) continue;
      compare_references(scene, references, timed->best.samples, result.reference_change);
      if (i > 0) add_orders(measured.points[i - 1], measured.points[i]);
    }
    result.curves.push_back(std::move(measured));
  }
  for (const Aside& aside : scene.asides) {
    const Trajectory reference = finished(scene, aside.reference);
    result.asides.emplace_back();
    for (std::size_t i = 0; i < aside.settings.size(); ++i) {
      result.asides.back().push_back(judged(scene, *++timed, reference));
    }
  }
  return result;
}

}  // namespace pupflow::report
