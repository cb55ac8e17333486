#include "app/report/stability_class.h"

#include <cmath>
#include <vector>

#include "app/report/stability_measure.h"

namespace pupflow::report {
namespace {

constexpr std::int64_t kStepsBetweenAsking = 50;

/// Running mean and sum of squared deviations (Welford).
struct Moments {
  std::int64_t count = 0;
  double mean = 0, squares = 0;
  void add(double value) {
    ++count;
    const double before = value - mean;
    mean += before / static_cast<double>(count);
    squares += before * (value - mean);
  }
  double deviation() const {
    return count > 1 ? std::sqrt(squares / static_cast<double>(count - 1)) : 0;
  }
};

/// What is gathered in the last quarter.
class Watch {
 public:
  explicit Watch(const Params& params)
      : gauge_(params),
        diameter_(2 * params.pup_radius),
        outside_(params.arena_radius + params.pup_radius) {}

  void look(const Simulation& simulation) {
    const std::vector<Shape>& shapes = gauge_.look(simulation);
    energies_.resize(shapes.size());
    escaped_ = false;
    for (std::size_t pup = 0; pup < shapes.size(); ++pup) {
      escaped_ = escaped_ || shapes[pup].centre.head<2>().norm() > outside_;
      energies_[pup].add(shapes[pup].energy);
      inverted_.add(shapes[pup].volume < 0 ? 1 : 0);
    }
    if (shapes.size() > 1) nearest_.add(nearest_centres(shapes) / diameter_);
  }

  Trial judge() const {
    Trial trial;
    Moments mean, swing;
    for (const Moments& energy : energies_) {
      mean.add(energy.mean);
      swing.add(energy.deviation());
    }
    trial.energy = mean.mean;
    trial.swing = swing.mean;
    trial.nearest = nearest_.mean;
    trial.inverted = inverted_.mean;
    if (trial.swing > kRingingSwing) trial.verdict = Verdict::ringing;
    if (nearest_.count > 0 && trial.nearest < kOverlap) trial.verdict = Verdict::interpenetrating;
    if (trial.inverted > kInvertedShare) trial.verdict = Verdict::inverted;
    if (escaped_) trial.verdict = Verdict::escaped;
    return trial;
  }

 private:
  ShapeGauge gauge_;
  double diameter_, outside_;
  bool escaped_ = false;
  std::vector<Moments> energies_;  // one per pup
  Moments nearest_, inverted_;
};

Trial lost(const Status& status) {
  Trial trial;
  const bool escaped = status.kind == Status::Kind::escaped;
  trial.verdict = escaped ? Verdict::escaped : Verdict::diverged;
  trial.status = status;
  return trial;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::stable:
      return "stable";
    case Verdict::ringing:
      return "ringing";
    case Verdict::interpenetrating:
      return "interpenetrating";
    case Verdict::inverted:
      return "inverted";
    case Verdict::escaped:
      return "escaped";
    case Verdict::diverged:
      return "diverged";
  }
  return "unknown";
}

std::optional<Trial> try_litter(const Params& params, const std::function<bool()>& stop) {
  Simulation simulation(params);
  Watch watch(params);
  const std::int64_t quarter = params.steps - params.steps / 4;
  while (simulation.steps_done() < params.steps) {
    if (simulation.steps_done() % kStepsBetweenAsking == 0 && stop()) return std::nullopt;
    const Status status = simulation.step();
    if (!status.ok()) return lost(status);
    if (simulation.steps_done() > quarter) watch.look(simulation);
  }
  return watch.judge();
}

std::optional<Trial> try_heat(const Params& params, const std::function<bool()>& stop) {
  if (stop()) return std::nullopt;
  Simulation simulation(params);
  const double equilibrium = params.ta + params.g / params.k1;
  const double first = params.tb0 - equilibrium;
  double before = first;
  std::int64_t turns = 0, steps = 0;
  Trial trial;
  while (simulation.steps_done() < params.steps) {
    const Status status = simulation.step();
    if (!status.ok()) return lost(status);
    const double now = simulation.body_temperature()[0] - equilibrium;
    if (std::abs(now) < 1e-9 * std::abs(first)) break;  // below, rounding decides
    turns += now * before < 0 ? 1 : 0;
    ++steps;
    before = now;
  }
  if (2 * turns > steps) trial.verdict = Verdict::ringing;
  if (std::abs(before) > std::abs(first)) trial.verdict = Verdict::diverged;
  return trial;
}

}  // namespace pupflow::report
