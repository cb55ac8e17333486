// What the validation report is made of: estimates over seeds, and what its sections measure.
#include <gtest/gtest.h>

#include <cmath>

#include "app/report/validation/flow.h"
#include "app/report/validation/heat.h"
#include "app/report/validation/readings.h"
#include "app/report/validation/symmetry.h"
#include "app/report/validation/units.h"
#include "pupflow/ensemble.h"
#include "pupflow/simulation.h"

namespace pupflow::report {
namespace {

Params cold_litter() {
  Params p;
  p.ambient_temperature = 0.2;
  p.steps = 700;
  return p;
}

TEST(Estimates, AreMeanAndStandardError) {
  const std::vector<double> values{1, 2, 3, 6};
  EXPECT_DOUBLE_EQ(mean_and_error(values).mean, 3);
  EXPECT_DOUBLE_EQ(mean_and_error(values).error, std::sqrt(14.0 / 3 / 4));
  EXPECT_TRUE(std::isnan(mean_and_error(std::vector{1.0}).error));
}

TEST(Estimates, ShowAsManyPlacesAsTheErrorHas) {
  EXPECT_EQ(text_of({0.58132, 0.0153}), "0.581 ± 0.015");
  EXPECT_EQ(text_of({8.6, 1.23}), "8.6 ± 1.2");
  EXPECT_EQ(text_of({123.4, 45}), "123 ± 45");
  EXPECT_EQ(text_of({0.5, std::nan("")}), "0.5");
  EXPECT_EQ(text_of({3, 0}), "3");
  EXPECT_EQ(text_of({1, 5e-17}), "1");
  EXPECT_EQ(text_of({0, 0}), "0");
}

TEST(AllRuns, GivesEachSettingAndSeedItsPlaceOnAnyNumberOfThreads) {
  std::vector<Params> settings(3);
  for (int i = 0; i < 3; ++i) settings[i].ambient_temperature = i;
  Options options;
  options.quiet = true;
  for (const int threads : {1, 3}) {
    options.threads = threads;
    const auto numbers = all_runs("x", settings, 2, options, [](const Params& p) {
      return std::vector{p.ambient_temperature,
                         10 * p.ambient_temperature + static_cast<double>(p.seed)};
    });
    ASSERT_EQ(numbers.size(), 3u);
    EXPECT_EQ(numbers[2][0], (std::vector{2.0, 2.0}));
    EXPECT_EQ(numbers[2][1], (std::vector{21.0, 22.0}));
  }
}

TEST(Readings, MeasureWhatASweepMeasures) {
  const Params p = cold_litter();
  const auto expected = run_to_end(p, [] { return false; });
  const std::vector<double> numbers = measure_reading(p);
  ASSERT_EQ(numbers.size(), kRunStatisticCount);
  for (const ObservableField& field : observables()) {
    EXPECT_EQ(numbers[statistic_of(field.observable)], expected->means.*field.value) << field.name;
  }
  EXPECT_EQ(numbers[kExposedSd], expected->exposed_sd);
}

ReadingCurve curve_with(const std::vector<double>& heights) {
  ReadingCurve curve{"", spaced(0, 1, static_cast<int>(heights.size())), {}, {}, {}};
  for (const double height : heights) curve.means.push_back({{height, 0.1}});
  return curve;
}

TEST(Readings, APeakIsAboveBothSides) {
  const Peak peak = peak_of(curve_with({1, 1, 3, 2, 2.5}), 0);
  EXPECT_EQ(peak.ta, 0.5);
  EXPECT_EQ(peak.height, 3);
  EXPECT_NEAR(peak.above, 1 / std::hypot(0.1, 0.1), 1e-12);
  EXPECT_EQ(peak_of(curve_with({1, 1, 3, 4, 5}), 0).above, 0);
}

TEST(Flow, LagOneIsTheObservablesAndAHundredComparesWithAHundredStepsAgo) {
  const Params p = cold_litter();
  const std::vector<double> numbers = measure_flow(p);
  EXPECT_NEAR(numbers[0], run_to_end(p, [] { return false; })->means.flow, 1e-12);
  Simulation simulation(p);
  std::vector<std::vector<double>> exposed;
  while (simulation.steps_done() <= p.steps) {
    exposed.emplace_back(simulation.view().exposed.begin(), simulation.view().exposed.end());
    simulation.step();
  }
  double sum = 0;
  for (std::int64_t step = p.discard + 1; step <= p.steps; ++step) {
    for (int pup = 0; pup < p.pups; ++pup) {
      sum += std::abs(exposed[step][pup] - exposed[step - 100][pup]);
    }
  }
  const double count = static_cast<double>(p.steps - p.discard) * p.pups;
  EXPECT_NEAR(numbers[3], sum / count / (100 * p.dt), 1e-12);
  EXPECT_GT(numbers[4], 0);
  EXPECT_LT(numbers[4], 1);
}

TEST(Heat, TheBalanceClosesButWhatPupsExchangeDoesNotCancel) {
  const HeatBalance b = heat_balance(cold_litter());
  EXPECT_NEAR(b.change, b.made - b.lost + b.exchanged, 1e-12);
  EXPECT_NEAR(b.made, Params{}.thermogenesis, 1e-12);
  EXPECT_GT(std::abs(b.exchanged), 1e-4);
  EXPECT_GT(b.moved, std::abs(b.exchanged));
}

TEST(Units, LittersPartAtTheFirstContactOnly) {
  const Parting parting = part_by_unit(cold_litter(), 10, 300);
  EXPECT_GT(parting.contact, 1);
  EXPECT_GE(parting.step, parting.contact);
  EXPECT_EQ(part_by_unit(cold_litter(), 1, 300).step, 0);
}

TEST(Symmetries, AMirroredBodyIsTheSameBody) {
  // Alone in the air, so that no rule has sides: the image moves as the image of the original.
  Params p;
  p.pups = 2;
  const Simulation start(p), image = mirrored(start);
  const Expected expected = [](const Simulation& a, int pup) {
    const Eigen::Vector3d c = a.view().positions.mean(pup);
    return Eigen::Vector3d(c.x(), -c.y(), c.z());
  };
  EXPECT_EQ(steps_until_apart(start, image, expected, 60), 61);
  // The image of the image is the original.
  EXPECT_EQ(mirrored(image).hash(), start.hash());
}

TEST(Symmetries, OtherNumbersMatterOnTheFloorAndNotAboveIt) {
  Simulation down(cold_litter());
  ASSERT_TRUE(down.run(400).ok());
  const Expected renumbered = [](const Simulation& a, int pup) {
    return a.view().positions.mean(pup_before(pup, a.pups()));
  };
  EXPECT_LE(steps_until_apart(down, relabelled(down), renumbered, 50), 50);
  const Simulation up = lifted(down);
  EXPECT_EQ(steps_until_apart(up, relabelled(up), renumbered, 20), 21);
}

}  // namespace
}  // namespace pupflow::report
