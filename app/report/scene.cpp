#include "app/report/scene.h"

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

Measured measure_setting(const Scene& scene, const Setting& setting, const Trajectory& right,
                         int repeats, Trajectory& samples) {
  Measured measured{setting, 0, {}, {}, {}};
  for (int i = 0; i < repeats; ++i) {
    stop_if_interrupted();
    const Outcome outcome = scene.run(setting);
    measured.status = outcome.status;
    measured.seconds = i == 0 ? outcome.seconds : std::min(measured.seconds, outcome.seconds);
    samples = outcome.samples;
    if (!outcome.status.ok()) break;
  }
  measured.errors = measured.status.ok() ? errors_of(samples, right)
                                         : std::vector<double>(scene.quantities.size(), kNone);
  measured.orders.assign(scene.quantities.size(), kNone);
  return measured;
}

/// Takes note of how much the errors change from one reference to the other.
void compare_references(const Answer& answer, const Trajectory& samples,
                        std::vector<double>& change) {
  const std::vector<double> one = errors_of(samples, answer.at_reference);
  const std::vector<double> other = errors_of(samples, answer.at_finer);
  for (std::size_t q = 0; q < change.size(); ++q) {
    if (other[q] > 0) change[q] = std::max(change[q], std::abs(one[q] / other[q] - 1));
  }
}

}  // namespace

std::vector<double> errors_of(const Trajectory& samples, const Trajectory& right) {
  std::vector<double> errors;
  for (std::size_t q = 0; q < right.size(); ++q) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < right[q].size(); ++i) {
      difference += std::pow(samples[q][i] - right[q][i], 2);
      size += std::pow(right[q][i], 2);
    }
    errors.push_back(std::sqrt(difference / size));
  }
  return errors;
}

SceneResult measure(const Scene& scene, const Options& options) {
  std::size_t total = 0, done = 0;
  for (const Curve& curve : scene.curves) total += curve.settings.size();
  io::Progress progress(scene.name, static_cast<std::int64_t>(total), options.quiet);
  const int repeats = options.quick ? 3 : 7;
  const Answer answer = answer_of(scene);
  SceneResult result;
  result.reference_change.assign(scene.quantities.size(), 0);
  Trajectory samples;
  result.standard = measure_setting(scene, scene.standard, answer.at_finer, repeats, samples);
  compare_references(answer, samples, result.reference_change);
  for (const Curve& curve : scene.curves) {
    MeasuredCurve measured{curve.name, curve.refines, {}};
    const Trajectory own =
        curve.reference.empty() ? Trajectory{} : finished(scene, curve.reference.front());
    for (const Setting& setting : curve.settings) {
      measured.points.push_back(
          measure_setting(scene, setting, own.empty() ? answer.at_finer : own, repeats, samples));
      Measured& now = measured.points.back();
      if (curve.refines && now.status.ok()) {
        if (own.empty()) compare_references(answer, samples, result.reference_change);
        for (std::size_t q = 0; q < now.errors.size() && measured.points.size() > 1; ++q) {
          now.orders[q] = std::log2(measured.points.end()[-2].errors[q] / now.errors[q]);
        }
      }
      progress.update(static_cast<std::int64_t>(++done));
    }
    result.curves.push_back(std::move(measured));
  }
  return result;
}

}  // namespace pupflow::report
