#include "app/report/stability/class.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/stability/measure.h"
#include "pupflow/overlap.h"

namespace pupflow::report {
namespace {

constexpr std::int64_t kStepsBetweenStops = 50;
constexpr std::int64_t kStepsBetweenOverlaps = 25;  // bodies overlap for longer than that

using Kind = Status::Kind;

// Light to dark from good to bad. Color-blind readers can tell any two apart (color difference CIEDE2000 above 20 in normal sight, protanopia, deuteranopia and tritanopia, after
// Machado, Oliveira & Fernandes 2009).
constexpr std::array<Class, kVerdicts> kClasses{{
    {"stable", "none of the following", nullptr, 0, {}, Kind::fine, "#E6EDF2"},
    {"ringing",
     "Deformation energy does not settle: its standard deviation in time, mean over pups. 0.001 is "
     "a swing of all points by some 3 % of the radius.",
     &Trial::swing,
     1e-3,
     {},
     Kind::fine,
     "#FFE728"},
    {"overlapping",
     "Share of all points that lie inside another body.",
     &Trial::inside,
     0.5,
     {},
     Kind::fine,
     "#90BBFD"},
    {"heating",
     "More kinetic energy than drive and gravity can give: mean over pups and time, over 2 f "
     "r_arena + g z, the energy of the drive across the arena and of a fall from the height of the "
     "highest pup at half time. Or the engine warns that a pup is higher than start and drive "
     "allow.",
     &Trial::kinetic, 1, Warning::Kind::gaining_energy, Kind::fine, "#A12511"},
    {"hanging", "The engine warns of a pup without support that does not fall.", nullptr, 0,
     Warning::Kind::hanging, Kind::fine, "#20867D"},
    {"sunk", "The engine warns of a pup's centre under the floor.", nullptr, 0, Warning::Kind::sunk,
     Kind::fine, "#2D436F"},
    {"inverted",
     "Share of samples of a pup whose fitted linear map has a determinant below 0: inverted for "
     "longer than a collision takes.",
     &Trial::inverted,
     0.01,
     {},
     Kind::fine,
     "#C18C09"},
    {"escaped", "The engine warns of a pup's centre outside the wall, or a step's status says so.",
     nullptr, 0, Warning::Kind::outside, Kind::escaped, "#9B53E0"},
    {"diverged",
     "A step's status: not finite, or far too large.",
     nullptr,
     0,
     {},
     Kind::diverged,
     "#222222"},
}};

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

/// Collects the measurements of one run.
class Record {
 public:
  explicit Record(const Params& params)
      : gauge_(params),
        energies_(static_cast<std::size_t>(params.pups)),
        given_(2 * params.drive * params.arena_radius) {}

  /// At half time: adds the energy that a fall can give.
  void add_height(const Simulation& simulation) {
    double highest = 0;
    for (int pup = 0; pup < simulation.pups(); ++pup) {
      highest = std::max(highest, simulation.view().positions.mean(pup).z());
    }
    given_ += simulation.params().gravity * highest;
  }

  void add(const Simulation& simulation) {
    const std::vector<Shape>& shapes = gauge_.measure(simulation);
    for (std::size_t pup = 0; pup < shapes.size(); ++pup) {
      energies_[pup].add(shapes[pup].energy);
      inverted_.add(shapes[pup].volume < 0 ? 1 : 0);
      kinetic_.add(shapes[pup].kinetic);
    }
    if (simulation.steps_done() % kStepsBetweenOverlaps == 0) {
      overlaps_.add(meter_.measure(simulation));
    }
  }

  Trial classify(const Simulation& simulation) const {
    Trial trial;
    const auto warnings = simulation.warnings();
    trial.warnings.assign(warnings.begin(), warnings.end());
    Moments mean, swing;
    for (const Moments& energy : energies_) {
      mean.add(energy.mean);
      swing.add(energy.deviation());
    }
    trial.energy = mean.mean;
    trial.swing = swing.mean;
    trial.kinetic = kinetic_.mean > 0 ? kinetic_.mean / given_ : 0;
    trial.inverted = inverted_.mean;
    if (simulation.pups() > 1 && overlaps_.count() > 0) {
      const Overlap overlap = overlaps_.means();
      trial.nearest = overlap.nearest / (2 * simulation.params().pup_radius);
      trial.inside = overlap.inside;
    }
    trial.verdict = worst_of(trial);
    return trial;
  }

 private:
  static Verdict worst_of(const Trial& trial) {
    int worst = 0;
    for (int i = 1; i < kVerdicts; ++i) {
      const Class& one = kClasses[static_cast<std::size_t>(i)];
      const bool warned = std::any_of(trial.warnings.begin(), trial.warnings.end(),
                                      [&](const Warning& w) { return w.kind == one.warning; });
      if (warned || (one.measure != nullptr && trial.*one.measure > one.limit)) worst = i;
    }
    return static_cast<Verdict>(worst);
  }

  ShapeGauge gauge_;
  OverlapMeter meter_;
  std::vector<Moments> energies_;  // one per pup
  double given_;
  Moments kinetic_, inverted_;
  OverlapMeans overlaps_;
};

}  // namespace

std::span<const Class> classes() {
  return kClasses;
}

Trial lost(const Status& status) {
  Trial trial;
  const bool escaped = status.kind == Kind::escaped;
  trial.verdict = escaped ? Verdict::escaped : Verdict::diverged;
  trial.status = status;
  return trial;
}

std::optional<Trial> try_litter(const Params& params, const std::function<bool()>& stop) {
  Simulation simulation(params);
  Record record(params);
  const std::int64_t half = params.steps / 2, quarter = params.steps - params.steps / 4;
  while (simulation.steps_done() < params.steps) {
    if (simulation.steps_done() % kStepsBetweenStops == 0 && stop()) return std::nullopt;
    const Status status = simulation.step();
    if (!status.ok()) return lost(status);
    if (simulation.steps_done() == half) record.add_height(simulation);
    if (simulation.steps_done() > quarter) record.add(simulation);
  }
  return record.classify(simulation);
}

}  // namespace pupflow::report
