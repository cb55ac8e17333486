#include "app/report/validation/heat.h"

#include <cmath>

#include "app/report/validation/runs.h"
#include "app/report/validation/sections.h"

namespace pupflow::report {
namespace {

/// Adds the terms of the last step.
void add_step(const LitterView& litter, HeatBalance& balance) {
  const Params& p = litter.params;
  const int points = litter.points;
  for (int pup = 0; pup < p.pups; ++pup) {
    const double tb = litter.felt_tb[pup], exposed = litter.exposed[pup];
    double sum = 0;
    int count = 0;
    for (const int other : litter.touched.subspan(pup * points, points)) {
      if (other < 0) continue;
      sum += litter.felt_tb[other];
      ++count;
    }
    const double gain = count > 0 ? -p.contact_conductance * (1 - exposed) * (tb - sum / count) : 0;
    balance.change += (litter.tb[pup] - tb) / p.dt;
    balance.made += p.thermogenesis;
    balance.lost += p.air_conductance * exposed * (tb - p.ambient_temperature);
    balance.exchanged += gain;
    balance.moved += std::abs(gain);
  }
}

}  // namespace

HeatBalance heat_balance(Params params) {
  params.heat = HeatRule::euler;
  Simulation simulation(params);
  HeatBalance balance;
  double steps = 0;
  while (simulation.steps_done() < params.steps) {
    step_on(simulation);
    if (simulation.steps_done() <= params.discard) continue;
    add_step(simulation, balance);
    ++steps;
  }
  for (double* sum :
       {&balance.change, &balance.made, &balance.lost, &balance.exchanged, &balance.moved}) {
    *sum /= steps * params.pups;
  }
  return balance;
}

void heat_section(Report& report) {
  const Options& options = report.options();
  report.heading("Heat balance");
  report.text(
      "The change of a pup's T_b is the heat that it makes, minus the heat that it loses to the "
      "air, plus the heat from the pups that it touches. If heat were conserved, the exchange "
      "between pups would add up to 0 over the litter. It does not: a pup takes the mean "
      "temperature of the points that it touches times its own share of points in contact, and of "
      "two pups in contact one can have more such points than the other. All numbers are per pup "
      "and model second, over steps 501 to 1500 and 2501 to 4000, with heat = euler, with which "
      "the terms add up in every step. Size is the mean absolute value of the exchange in a step.");
  std::vector<Params> settings;
  for (const std::int64_t end :
       options.quick ? std::vector<std::int64_t>{1500} : std::vector<std::int64_t>{1500, 4000}) {
    for (const double ta :
         options.quick ? std::vector{0.2, 0.8} : std::vector{0.0, 0.2, 0.4, 0.5, 0.6, 0.8}) {
      settings.emplace_back();
      settings.back().ambient_temperature = ta;
      settings.back().steps = end;
      settings.back().discard = end == 1500 ? 500 : 2500;
    }
  }
  const auto means =
      means_of_runs("heat", settings, options.quick ? 2 : 6, options,
                    [](const Params& params) -> std::vector<double> {
                      const HeatBalance b = heat_balance(params);
                      return {b.change, b.made, b.lost, b.exchanged, b.exchanged / b.made, b.moved};
                    });
  io::CsvFile csv = report.csv("heat", settings[0],
                               "ta,steps,change,change_se,made,made_se,lost,lost_se,exchanged,"
                               "exchanged_se,ratio,ratio_se,size,size_se");
  std::vector<io::Row> rows{{"T_a", "steps", "change of T_b", "made, G", "lost to the air",
                             "from others", "from others, of G", "size"}};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Params& p = settings[i];
    csv.cell(p.ambient_temperature).cell(p.steps);
    rows.push_back({rounded(p.ambient_temperature),
                    std::to_string(p.discard + 1) + "–" + std::to_string(p.steps)});
    end_row(means[i], csv, rows);
  }
  csv.commit();
  report.table(rows);
}

}  // namespace pupflow::report
