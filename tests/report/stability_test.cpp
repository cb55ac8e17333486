// The stability report's parts: what it measures, what it calls a run, its extreme scenes.
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include <atomic>
#include <set>

#include "app/report/share_out.h"
#include "app/report/stability/cells.h"
#include "app/report/stability/class.h"
#include "app/report/stability/extreme/scenes.h"
#include "app/report/stability/heat.h"
#include "app/report/stability/maps.h"
#include "app/report/stability/measure.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

bool never() {
  return false;
}

Shape shape_after(const Eigen::Matrix3d& map) {
  Params params = pupflow::testing::weightless();
  Simulation simulation(params);
  auto points = pupflow::testing::all_positions(simulation);
  const Eigen::Vector3d centre = simulation.view().positions.mean(0), moved(1, 2, 30);
  for (Eigen::Vector3d& point : points) point = moved + map * (point - centre);
  pupflow::testing::place(simulation, 0, points, points);
  return shapes_of(simulation).front();
}

TEST(ShapeGauge, ARotatedAndMovedBodyIsAtRest) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized())).toRotationMatrix();
  const Shape shape = shape_after(turn);
  EXPECT_NEAR(shape.energy, 0, 1e-25);
  EXPECT_NEAR(shape.volume, 1, 1e-12);
  EXPECT_NEAR((shape.centre - Eigen::Vector3d(1, 2, 30)).norm(), 0, 1e-12);
}

TEST(ShapeGauge, KnowsTheEnergyAndVolumeOfASimpleDeformation) {
  // Twice as large: every point is a radius from where it should be.
  EXPECT_NEAR(shape_after(2 * Eigen::Matrix3d::Identity()).energy, 1, 1e-12);
  EXPECT_NEAR(shape_after(2 * Eigen::Matrix3d::Identity()).volume, 8, 1e-12);
  EXPECT_NEAR(shape_after(-Eigen::Matrix3d::Identity()).volume, -1, 1e-12);
  EXPECT_NEAR(shape_after(Eigen::Vector3d(1, 1, 0).asDiagonal()).volume, 0, 1e-12);
}

TEST(ShapeGauge, KnowsTheKineticEnergyOfEveryPoint) {
  // Velocities are the positions here: the centre's at (1, 2, 30), and r = 0.25 round it.
  const double expected = (1 + 4 + 900 + 0.25 * 0.25) / 2;
  EXPECT_NEAR(shape_after(Eigen::Matrix3d::Identity()).kinetic, expected, 1e-10);
}

Trial tried(void (*edit)(Params&)) {
  Params params;
  edit(params);
  return *try_litter(params, never);
}

TEST(Verdict, TheDefaultLitterIsStableColdWarmAndInBetween) {
  for (const double ta : {0.2, 0.48, 0.8}) {
    Params params;
    params.ambient_temperature = ta;
    const Trial trial = *try_litter(params, never);
    EXPECT_EQ(trial.verdict, Verdict::stable) << class_of(trial.verdict).name;
    EXPECT_LT(trial.swing, class_of(Verdict::ringing).limit / 10);  // with room
    EXPECT_LT(trial.kinetic, class_of(Verdict::heating).limit / 10);
    EXPECT_LT(trial.inside, class_of(Verdict::overlapping).limit / 1.2);
    EXPECT_EQ(trial.inverted, 0);
    EXPECT_GT(trial.energy, 1e-5);
    EXPECT_GT(trial.kinetic, 1e-4);
    EXPECT_GT(trial.nearest, 0.5);
    EXPECT_TRUE(trial.warnings.empty());
  }
}

/// A class and a litter that belongs to it.
struct Member {
  Verdict verdict;
  void (*edit)(Params&);
};

TEST(Verdict, EachClassHasAKnownMember) {
  const Member members[] = {
      {Verdict::ringing,
       [](Params& p) {
         p.rigidity = 0.1;
         p.deformation = 0.8;
       }},
      {Verdict::overlapping, [](Params& p) { p.pup_radius = 1.9; }},
      {Verdict::hanging,
       [](Params& p) {
         p.drive = 25;  // pinned to the wall, up in the air
         p.steps = 600;
       }},
      {Verdict::sunk, [](Params& p) { p.dt = 0.1; }},
      {Verdict::inverted, [](Params& p) { p.deformation = 1; }},
      {Verdict::escaped, [](Params& p) { p.drive = 1000; }},
  };
  for (const Member& member : members) {
    const Trial trial = tried(member.edit);
    EXPECT_EQ(trial.verdict, member.verdict)
        << class_of(trial.verdict).name << " for " << class_of(member.verdict).name;
  }
  const Trial lost = tried([](Params& p) { p.integrator = Integrator::explicit_; });
  EXPECT_EQ(lost.verdict, Verdict::diverged);
  EXPECT_EQ(lost.status.kind, Status::Kind::diverged);
  EXPECT_EQ(lost.status.stage, Stage::predict);
  EXPECT_GT(lost.status.step, 100);
}

TEST(Verdict, MoreKineticEnergyThanDriveAndGravityGiveIsHeating) {
  // Explicit steps do not damp: the litter gets hot before anybody is out of bounds.
  const Trial hot = tried([](Params& p) {
    p.integrator = Integrator::explicit_;
    p.rigidity = 0.08;
    p.steps = 1360;
  });
  EXPECT_EQ(hot.verdict, Verdict::heating);
  EXPECT_GT(hot.kinetic, 1.2);
  EXPECT_TRUE(hot.warnings.empty());
  // Close to no shape of its own, a body that is pressed throws another up.
  const Trial thrown = tried([](Params& p) { p.deformation = 0.9; });
  EXPECT_EQ(thrown.verdict, Verdict::heating);
  ASSERT_EQ(thrown.warnings.size(), 1u);
  EXPECT_EQ(thrown.warnings[0].kind, Warning::Kind::gaining_energy);
}

TEST(Verdict, APupThatIsOutsideButNotYetFarIsEscapedToo) {
  const Trial trial = tried([](Params& p) { p.drive = 60; });
  EXPECT_TRUE(trial.status.ok());
  EXPECT_EQ(trial.verdict, Verdict::escaped);
}

TEST(Verdict, HeatRingsAndDivergesWhereEulerDoes) {
  for (const auto& [k1_h, verdict] :
       {std::pair(0.5, Verdict::stable), std::pair(1.5, Verdict::ringing),
        std::pair(1.95, Verdict::ringing), std::pair(2.05, Verdict::diverged),
        std::pair(50.0, Verdict::diverged)}) {
    Params params;
    params.pups = 1;
    params.gravity = params.drive = 0;
    params.steps = 400;
    params.air_conductance = k1_h / params.dt;
    params.heat = HeatRule::euler;
    EXPECT_EQ(try_heat(params, never)->verdict, verdict) << k1_h;
    params.heat = HeatRule::exact;
    EXPECT_EQ(try_heat(params, never)->verdict, Verdict::stable) << k1_h;
  }
}

TEST(Verdict, ExchangeOfHeatRingsAndDivergesAsInTheory) {
  Params params;
  params.pups = 2;
  params.gravity = params.drive = params.air_conductance = params.thermogenesis = 0;
  params.steps = 400;
  const double contact = held_contact(params);
  ASSERT_GT(contact, 0.05);
  ASSERT_LT(contact, 0.95);
  // The difference is multiplied by 1 - 2 kappa, or by 2 exp(-kappa) - 1.
  struct Case {
    double kappa;
    Verdict exact, euler;
  };
  for (const Case& one :
       {Case{0.4, Verdict::stable, Verdict::stable}, Case{0.6, Verdict::stable, Verdict::ringing},
        Case{0.8, Verdict::ringing, Verdict::ringing},
        Case{1.05, Verdict::ringing, Verdict::diverged},
        Case{1000, Verdict::ringing, Verdict::diverged}}) {
    params.contact_conductance = one.kappa / (contact * params.dt);
    params.heat = HeatRule::exact;
    EXPECT_EQ(try_exchange(params, never)->verdict, one.exact) << one.kappa;
    params.heat = HeatRule::euler;
    EXPECT_EQ(try_exchange(params, never)->verdict, one.euler) << one.kappa;
  }
}

TEST(Verdict, StopsWhenAsked) {
  EXPECT_FALSE(try_litter(Params{}, [] { return true; }));
}

Cell cell_of(std::initializer_list<Verdict> verdicts) {
  Cell cell;
  for (const Verdict verdict : verdicts) {
    cell.trials.emplace_back();
    cell.trials.back().verdict = verdict;
  }
  return cell;
}

TEST(Cell, IsWhatMostSeedsSayOrTheMiddleOne) {
  constexpr Verdict kGood = Verdict::stable, kBad = Verdict::ringing, kWorst = Verdict::diverged;
  const Cell agreed = cell_of({kBad, kBad, kBad});
  EXPECT_EQ(agreed.verdict(), kBad);
  EXPECT_EQ(agreed.agreeing(), 3);
  EXPECT_FALSE(agreed.other());
  for (const Cell& cell : {cell_of({kWorst, kGood, kGood}), cell_of({kGood, kWorst, kGood})}) {
    EXPECT_EQ(cell.verdict(), kGood);
    EXPECT_EQ(cell.agreeing(), 2);
    EXPECT_EQ(cell.other(), kWorst);
  }
  const Cell split = cell_of({kWorst, kGood, kBad});
  EXPECT_EQ(split.verdict(), kBad);
  EXPECT_EQ(split.agreeing(), 1);
  EXPECT_EQ(split.other(), kWorst);
}

TEST(Cell, MeansAreOverTheRunsThatEnded) {
  Cell cell = cell_of({Verdict::stable, Verdict::diverged, Verdict::stable});
  cell.trials[0].kinetic = 1;
  cell.trials[2].kinetic = 2;
  cell.trials[1].status.kind = Status::Kind::diverged;
  EXPECT_EQ(cell.mean(&Trial::kinetic), 1.5);
  EXPECT_EQ(cell.lost(), &cell.trials[1]);
}

TEST(StabilityMaps, HaveTheDefaultAmongTheirCellsAndTheirCellsAreSoundOrRefused) {
  for (const bool quick : {false, true}) {
    std::set<std::string> names;
    for (const StabilityMap& map : stability_maps(quick)) {
      names.insert(map.name);
      ASSERT_EQ(map.methods.size(), 2u);
      EXPECT_EQ(map.seeds, map.classify == try_litter ? 3 : 1) << map.name;
      EXPECT_TRUE(map.classify != try_litter || map.base.pups == 12) << map.name;
      for (const MapAxis* axis : {&map.x, &map.y}) {
        EXPECT_TRUE(std::is_sorted(axis->values.begin(), axis->values.end())) << axis->name;
      }
      int refused = 0;
      for (const Method& method : map.methods) {
        for (const double x : map.x.values) {
          for (const double y : map.y.values) {
            const Params cell = cell_params(map, method, x, y, 2);
            EXPECT_EQ(cell.seed, 2);
            EXPECT_DOUBLE_EQ(map.x.get(cell), x);
            EXPECT_DOUBLE_EQ(map.y.get(cell), y);
            refused += check(cell).empty() ? 0 : 1;
          }
        }
      }
      // Consistent refinement has no alpha = 1 below the reference step.
      EXPECT_EQ(refused > 0, map.name == "step_refinement") << map.name;
      EXPECT_FALSE(cell_params(map, map.methods[1], map.x.values[0], map.y.values[0], 1) ==
                   cell_params(map, map.methods[0], map.x.values[0], map.y.values[0], 1));
    }
    EXPECT_THAT(names, ElementsAre("alpha_beta", "drive_pups", "points", "radii", "step_alpha",
                                   "step_gravity", "step_k1", "step_k2", "step_refinement"));
  }
}

TEST(StabilityMaps, AreTheSameForAnyNumberOfThreads) {
  StabilityMap map = stability_maps(true)[0];
  map.base.pups = 4;
  map.base.steps = 200;
  Options options;
  options.quiet = true;
  const MapResult one = compute_map(map, options);
  options.threads = 3;
  const MapResult three = compute_map(map, options);
  for (std::size_t m = 0; m < one.size(); ++m) {
    for (std::size_t j = 0; j < one[m].size(); ++j) {
      for (std::size_t i = 0; i < one[m][j].size(); ++i) {
        const Cell &a = one[m][j][i], &b = three[m][j][i];
        ASSERT_EQ(a.trials.size(), 3u);
        ASSERT_EQ(b.trials.size(), 3u);
        for (std::size_t s = 0; s < 3; ++s) {
          EXPECT_EQ(a.trials[s].verdict, b.trials[s].verdict);
          EXPECT_EQ(a.trials[s].kinetic, b.trials[s].kinetic);
          EXPECT_EQ(a.trials[s].energy, b.trials[s].energy);
        }
      }
    }
  }
}

TEST(StabilityMaps, RefusedCellsAreNotRun) {
  StabilityMap map = stability_maps(true)[0];
  for (const StabilityMap& one : stability_maps(true)) {
    if (one.name == "step_refinement") map = one;
  }
  map.x.values = {0.005, 0.01};
  map.y.values = {0.7, 1};
  map.base.pups = 1;
  map.base.steps = 20;
  Options options;
  options.quiet = true;
  const MapResult result = compute_map(map, options);
  EXPECT_THAT(result[1][1][0].refused, HasSubstr("alpha = 1"));
  EXPECT_TRUE(result[1][1][0].trials.empty());
  EXPECT_EQ(result[1][1][1].trials.size(), 3u);
  EXPECT_EQ(result[0][1][0].trials.size(), 3u);
}

TEST(ShareOut, DoesEachPieceOnceAndPassesOnWhatWentWrong) {
  Options options;
  options.quiet = true;
  for (const int threads : {1, 3}) {
    options.threads = threads;
    std::vector<std::atomic<int>> done(100);
    share_out("pieces", 100, options, [&](std::int64_t i) { ++done[static_cast<std::size_t>(i)]; });
    for (const auto& count : done) EXPECT_EQ(count, 1);
    std::atomic<int> begun{0};
    EXPECT_THROW(share_out("pieces", 1000, options,
                           [&](std::int64_t) {
                             ++begun;
                             throw std::runtime_error("bad");
                           }),
                 std::runtime_error);
    EXPECT_LE(begun, threads);
  }
}

class Extreme : public ::testing::TestWithParam<std::tuple<std::size_t, Precision>> {};

TEST_P(Extreme, DoesWhatItShould) {
  const ExtremeScene& scene = extreme_scenes()[std::get<0>(GetParam())];
  const Finding finding = scene.run(std::get<1>(GetParam()), true);
  EXPECT_TRUE(finding.ok) << scene.scene << ". " << scene.expected << "\n" << finding.happened;
  EXPECT_THAT(finding.happened, ::testing::Not(HasSubstr("|")));  // it stands in a table
}

INSTANTIATE_TEST_SUITE_P(
    All, Extreme,
    ::testing::Combine(::testing::Range(std::size_t{0}, extreme_scenes().size()),
                       ::testing::Values(Precision::float_, Precision::double_)),
    [](const auto& test) {
      return std::string(extreme_scenes()[std::get<0>(test.param)].name) +
             (std::get<1>(test.param) == Precision::float_ ? "_float" : "_double");
    });

}  // namespace
}  // namespace pupflow::report
