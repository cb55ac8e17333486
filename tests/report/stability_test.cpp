// The stability report's parts: what it measures, what it calls a run, its extreme scenes.
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include <atomic>
#include <set>

#include "app/report/share_out.h"
#include "app/report/stability_class.h"
#include "app/report/stability_maps.h"
#include "app/report/stability_measure.h"
#include "app/report/stability_scenes.h"
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
  const Eigen::Vector3d centre = simulation.centre(0), moved(1, 2, 30);
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

TEST(ShapeGauge, FindsTheNearestCentres) {
  std::vector<Shape> shapes(3);
  shapes[0].centre = {0, 0, 0};
  shapes[1].centre = {3, 0, 0};
  shapes[2].centre = {3, 2, 0};
  EXPECT_EQ(nearest_centres(shapes), 2);
  shapes.resize(1);
  EXPECT_TRUE(std::isinf(nearest_centres(shapes)));
}

Trial tried(void (*edit)(Params&)) {
  Params params;
  params.pups = 6;
  edit(params);
  return *try_litter(params, never);
}

TEST(Verdict, ThePapersLitterIsStable) {
  for (const std::int64_t seed : {1, 2, 3}) {
    Params params;
    params.seed = seed;
    const Trial trial = *try_litter(params, never);
    EXPECT_EQ(trial.verdict, Verdict::stable) << verdict_name(trial.verdict);
    EXPECT_LT(trial.swing, kRingingSwing / 3);  // with room
    EXPECT_GT(trial.nearest, kOverlap * 1.4);
    EXPECT_EQ(trial.inverted, 0);
    EXPECT_GT(trial.energy, 1e-5);
  }
}

TEST(Verdict, EachClassHasAKnownMember) {
  EXPECT_EQ(tried([](Params& p) {
              p.alpha = 0.1;
              p.beta = 0.8;
            }).verdict,
            Verdict::ringing);
  EXPECT_EQ(tried([](Params& p) { p.beta = 1; }).verdict, Verdict::inverted);
  EXPECT_EQ(tried([](Params& p) { p.drive = 1000; }).verdict, Verdict::escaped);
  // k = 2: 24 points a pup let bodies sink into each other.
  EXPECT_EQ(tried([](Params& p) {
              p.pups = 12;
              p.face_points = 2;
            }).verdict,
            Verdict::interpenetrating);
  const Trial lost = tried([](Params& p) { p.integrator = Integrator::explicit_; });
  EXPECT_EQ(lost.verdict, Verdict::diverged);
  EXPECT_EQ(lost.status.kind, Status::Kind::diverged);
  EXPECT_EQ(lost.status.stage, Stage::predict);
  EXPECT_GT(lost.status.step, 100);
}

TEST(Verdict, APupThatIsOutsideButNotYetFarIsEscapedToo) {
  const Trial trial = tried([](Params& p) { p.drive = 80; });
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
    params.k1 = k1_h / params.dt;
    params.heat = HeatRule::euler;
    EXPECT_EQ(try_heat(params, never)->verdict, verdict) << k1_h;
    params.heat = HeatRule::exact;
    EXPECT_EQ(try_heat(params, never)->verdict, Verdict::stable) << k1_h;
  }
}

TEST(Verdict, StopsWhenAsked) {
  EXPECT_FALSE(try_litter(Params{}, [] { return true; }));
}

TEST(StabilityMaps, HaveTheDefaultAmongTheirCellsAndSoundParameters) {
  for (const bool quick : {false, true}) {
    std::set<std::string> names;
    for (const StabilityMap& map : stability_maps(quick)) {
      names.insert(map.name);
      ASSERT_EQ(map.methods.size(), 2u);
      for (const MapAxis* axis : {&map.x, &map.y}) {
        EXPECT_TRUE(std::is_sorted(axis->values.begin(), axis->values.end())) << axis->parameter;
      }
      for (const Method& method : map.methods) {
        for (const double x : map.x.values) {
          for (const double y : map.y.values) {
            const Params cell = cell_params(map, method, x, y);
            EXPECT_TRUE(check(cell).empty()) << map.name << ' ' << x << ' ' << y;
            EXPECT_EQ(find_parameter(map.x.parameter)->get(cell), x);
            EXPECT_EQ(find_parameter(map.y.parameter)->get(cell), y);
          }
        }
      }
      EXPECT_EQ(cell_params(map, map.methods[1], map.x.values[0], map.y.values[0]) ==
                    cell_params(map, map.methods[0], map.x.values[0], map.y.values[0]),
                false);
    }
    EXPECT_THAT(names,
                ElementsAre("alpha_beta", "drive_pups", "step_alpha", "step_gravity", "step_k1"));
  }
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
