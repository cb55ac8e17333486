// Looking at fields changes no bit of a litter, and what they show is what the stages read.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "pupflow/fields.h"
#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using Setting = std::tuple<Precision, Heading>;

std::string setting_name(const ::testing::TestParamInfo<Setting>& info) {
  return std::string(std::get<0>(info.param) == Precision::float_ ? "float" : "double") + "_" +
         (std::get<1>(info.param) == Heading::course ? "course" : "body");
}

const auto kSettings = ::testing::Combine(::testing::Values(Precision::float_, Precision::double_),
                                          ::testing::Values(Heading::course, Heading::body));

/// Pups that touch soon and stay together.
Params crowd(const Setting& setting) {
  Params p;
  p.pups = 4;
  p.face_points = 4;
  p.arena_radius = 0.7;
  p.ambient_temperature = 0.3;
  std::tie(p.precision, p.heading) = setting;
  return p;
}

struct Observing : ::testing::TestWithParam<Setting> {};

/// The parts that fields need, each set once, and all at once.
std::vector<PartSet> observers() {
  std::vector<PartSet> sets{PartSet::all()};
  const auto add = [&](const Field& field) {
    if (std::find(sets.begin(), sets.end(), field.parts) == sets.end()) sets.push_back(field.parts);
  };
  for (const Field& field : pup_fields()) add(field);
  for (const Field& field : afferent_fields()) add(field);
  for (const Field& field : observables()) add(field);
  return sets;
}

/// Each observer looks at all steps, or at every other one.
TEST_P(Observing, ChangesNoBit) {
  const std::vector<PartSet> wanted = observers();
  constexpr int kSteps = 150;
  for (const auto& edit : {+[](Params&) {}, +[](Params& p) { p.drive = p.rigidity = 0; },
                           +[](Params& p) {
                             p.integrator = Integrator::explicit_;
                             p.rigidity = 0.1;
                           }}) {
    Params p = crowd(GetParam());
    edit(p);
    Simulation lean(p);
    lean.set_observed({});
    std::vector<Simulation> watched;
    for (std::size_t i = 0; i < 2 * wanted.size(); ++i) watched.push_back(lean);
    for (int step = 0; step < kSteps; ++step) {
      lean.step();
      for (std::size_t i = 0; i < watched.size(); ++i) {
        const bool looks = i < wanted.size() || step % 2 == 0;
        watched[i].set_observed(looks ? wanted[i % wanted.size()] : PartSet{});
        watched[i].step();
        ASSERT_EQ(watched[i].hash(), lean.hash()) << "observer " << i << ", step " << step;
      }
    }
  }
}

TEST_P(Observing, AFieldAloneShowsWhatAllShow) {
  Params p = crowd(GetParam());
  Simulation all(p);
  all.set_observed(PartSet::all());
  all.run(200);
  for (const std::span<const LitterField> table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      Simulation alone(p);
      alone.set_observed(field.parts);
      alone.run(200);
      EXPECT_EQ(field.values(alone), field.values(all)) << field.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, Observing, kSettings, setting_name);

double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

/// Heat and steering of a step, worked out from what its afferents felt and nothing else of it.
class Rebuilt {
 public:
  explicit Rebuilt(const LitterView& after)
      : params_(after.params),
        points_(static_cast<std::size_t>(after.points)),
        temperature_(find_field("temperature")->values(after)),
        touched_(find_field("touched")->values(after)),
        side_(find_field("side")->values(after)),
        felt_tb_(find_field("felt_tb")->values(after)) {}

  /// The exact solution of dT_b/dt = G - k1 A (T_b - T_a) - k2 (1 - A) (T_b - mean T_c).
  double tb(std::size_t pup) const {
    double touching = 0, sum = 0;
    for (std::size_t i = pup * points_; i < (pup + 1) * points_; ++i) {
      if (touched_[i] < 0) continue;
      ++touching;
      sum += temperature_[i];
    }
    const double a = 1 - touching / static_cast<double>(points_);
    const double air = params_.air_conductance * a, skin = params_.contact_conductance * (1 - a);
    const double mean = touching > 0 ? sum / touching : 0, k = air + skin;
    const double settled =
        (params_.thermogenesis + air * params_.ambient_temperature + skin * mean) / k;
    return settled + (felt_tb_[pup] - settled) * std::exp(-k * params_.dt);
  }

  /// Mean of T_c on the left (1) or right (0).
  double felt(std::size_t pup, double side) const {
    double sum = 0, count = 0;
    for (std::size_t i = pup * points_; i < (pup + 1) * points_; ++i) {
      if (side_[i] != side) continue;
      sum += temperature_[i];
      ++count;
    }
    return sum / count;
  }

  /// Delta theta.
  double turn(std::size_t pup) const {
    const auto sensor = [&](double felt) {
      const double need = params_.preferred_temperature - felt_tb_[pup];
      return 1 / (1 + std::exp(-params_.sensitivity * felt * need));
    };
    const double left = sensor(felt(pup, 1)), right = sensor(felt(pup, 0));
    return std::atan(params_.steering_gain * (left - right) / (left + right));
  }

 private:
  const Params& params_;
  std::size_t points_;
  std::vector<double> temperature_, touched_, side_, felt_tb_;
};

struct Rebuilding : ::testing::TestWithParam<Setting> {};

TEST_P(Rebuilding, HeatAndSteeringFollowFromTheAfferents) {
  const Params p = crowd(GetParam());
  Simulation s(p);
  s.set_observed(PartSet::all());
  int touching = 0, turning = 0;
  for (int step = 0; step < 600; ++step) {
    const std::vector<double> before = find_field("heading")->values(s);
    const std::vector<double> tb_before = find_field("tb")->values(s);
    ASSERT_TRUE(s.step().ok());
    const LitterView after = s;
    EXPECT_EQ(find_field("felt_tb")->values(s), tb_before) << step;
    const Rebuilt rebuilt(after);
    for (std::size_t pup = 0; pup < 4; ++pup) {
      ASSERT_NEAR(after.tb[pup], rebuilt.tb(pup), 1e-14) << step << ' ' << pup;
      ASSERT_NEAR(after.t_left[pup], rebuilt.felt(pup, 1), 1e-14) << step << ' ' << pup;
      ASSERT_NEAR(after.t_right[pup], rebuilt.felt(pup, 0), 1e-14) << step << ' ' << pup;
      // The gain of 200 and sigma = 38 amplify the rounding of the two means.
      ASSERT_NEAR(after.turn[pup], rebuilt.turn(pup), 1e-11) << step << ' ' << pup;
      if (p.heading == Heading::course) {
        const double expected = before[pup] + p.dt * rebuilt.turn(pup);
        ASSERT_NEAR(wrapped(after.heading[pup] - expected), 0, 1e-12) << step << ' ' << pup;
      }
      touching += after.exposed[pup] < 1 ? 1 : 0;
      turning += std::abs(after.turn[pup]) > 0.1 ? 1 : 0;
    }
  }
  EXPECT_GT(touching, 600);  // of 2400
  EXPECT_GT(turning, 300);
}

// heading = body: theta = psi + turn, with psi the axis from the tail (the first point) to the
// centre, from positions after boundary and contact. These do not move a pup that rests in the air
// under another, so psi is that of the step before.
void expect_body_heading(Precision precision) {
  Params p = testing::weightless();
  p.pups = 2;
  p.drive = 1;
  p.precision = precision;
  p.heading = Heading::body;
  Simulation s(p);
  s.set_observed(PartSet::all());
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3.5).normalized()).toRotationMatrix();
  for (int pup = 0; pup < 2; ++pup) {
    testing::Points points;
    for (const auto& q : cube_sphere(p.face_points, p.pup_radius)) {
      points.push_back(turned * q + Eigen::Vector3d(0.2 * pup, 0, 2 + 0.52 * pup));
    }
    testing::place(s, pup, points, testing::Points(points.size(), Eigen::Vector3d::Zero()));
  }
  s.set_body_temperature(1, 0.8);
  s.set_body_temperature(0, 0.5);
  const LitterView before = s;
  const Eigen::Vector3d axis = before.positions.mean(0) - before.positions(0, 0);
  const double psi = std::atan2(axis.y(), axis.x());
  ASSERT_TRUE(s.step().ok());
  const Rebuilt rebuilt(s);
  EXPECT_GT(std::abs(rebuilt.turn(0)), 0.1);
  const double tolerance = p.precision == Precision::float_ ? 1e-6 : 1e-12;
  EXPECT_NEAR(wrapped(s.view().heading[0] - psi - rebuilt.turn(0)), 0, tolerance);
}

TEST(BodyHeading, IsTheAxisAndTheTurn) {
  expect_body_heading(Precision::double_);
  expect_body_heading(Precision::float_);
}

INSTANTIATE_TEST_SUITE_P(Fields, Rebuilding, kSettings, setting_name);

}  // namespace
}  // namespace pupflow
