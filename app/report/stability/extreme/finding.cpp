#include "app/report/stability/extreme/finding.h"

#include <algorithm>
#include <cmath>

#include "app/report/report.h"

namespace pupflow::report::extreme {

Params base(Precision precision) {
  Params params;
  params.precision = precision;
  return params;
}

Params weightless(Precision precision) {
  Params params = weightless_pup();
  params.precision = precision;
  return params;
}

bool is_double(Precision precision) {
  return precision == Precision::double_;
}

bool finite(const LitterView& litter) {
  const auto all = [](const auto& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  return all(to_numbers(of_all(litter.positions))) && all(to_numbers(of_all(litter.velocities))) &&
         all(litter.tb) && all(litter.heading) && all(litter.exposed);
}

double largest_energy(const std::vector<Shape>& shapes) {
  double energy = 0;
  for (const Shape& shape : shapes) energy = std::max(energy, shape.energy);
  return energy;
}

double smallest_volume(const std::vector<Shape>& shapes) {
  double volume = 1e300;
  for (const Shape& shape : shapes) volume = std::min(volume, shape.volume);
  return volume;
}

Finding run_fine(Simulation& simulation, std::int64_t steps) {
  constexpr std::int64_t kAtOnce = 1000;
  for (std::int64_t done = 0; done < steps; done += kAtOnce) {
    stop_if_interrupted();
    const Status status = simulation.run(std::min(kAtOnce, steps - done));
    if (!status.ok()) return {false, status.message()};
  }
  Finding finding{finite(simulation), std::to_string(steps) + " steps, all numbers finite"};
  add_warnings(finding, simulation);
  return finding;
}

void add_warnings(Finding& finding, const Simulation& simulation) {
  const std::string text = warnings_text(simulation.warnings());
  if (!text.empty()) finding.happened += "; warning: " + text;
}

bool warned(const Simulation& simulation, Warning::Kind kind) {
  const auto warnings = simulation.warnings();
  return std::any_of(warnings.begin(), warnings.end(),
                     [kind](const Warning& warning) { return warning.kind == kind; });
}

void require(Finding& finding, const std::string& what, double value, double low, double high) {
  finding.ok = finding.ok && value >= low && value <= high;
  finding.happened += "; " + what + " " + rounded(value);
}

Finding run_until(const Params& params, std::int64_t steps, Status::Kind kind, Stage stage) {
  Simulation simulation(params);
  const Status status = simulation.run(steps);
  Finding finding{
      status.kind == kind && status.stage == stage && status.step == simulation.steps_done() + 1,
      status.ok() ? "fine after " + std::to_string(steps) + " steps" : status.message()};
  add_warnings(finding, simulation);
  return finding;
}

Finding both(const std::string& one_name, const Finding& one, const std::string& other_name,
             const Finding& other) {
  return {one.ok && other.ok,
          one_name + ": " + one.happened + ". " + other_name + ": " + other.happened};
}

Finding fine_but(const NamedRun& fine, const NamedRun& bad, Status::Kind kind, Stage stage) {
  Simulation simulation(fine.params);
  const Finding first = run_fine(simulation, fine.steps);
  return both(fine.name, first, bad.name, run_until(bad.params, bad.steps, kind, stage));
}

}  // namespace pupflow::report::extreme
