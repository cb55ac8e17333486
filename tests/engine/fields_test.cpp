// Every field of the tables against values worked out by hand: at rest, alone, in contact.
#include "pupflow/fields.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

/// What a field called `name` shows.
std::vector<double> shown(const Simulation& simulation, std::string_view name) {
  return find_field(name)->values(simulation);
}

/// A weightless litter whose steps record everything.
Simulation litter(int pups, void (*edit)(Params&) = nullptr) {
  Params p = testing::weightless();
  p.pups = pups;
  if (edit != nullptr) edit(p);
  Simulation simulation(p);
  simulation.set_observed(PartSet::all());
  return simulation;
}

/// The pup at rest, moved by `linear` and then to `centre`.
testing::Points body(const Simulation& simulation, const Eigen::Matrix3d& linear,
                     const Eigen::Vector3d& centre) {
  testing::Points points;
  for (const auto& q :
       cube_sphere(simulation.params().face_points, simulation.params().pup_radius)) {
    points.push_back(linear * q + centre);
  }
  return points;
}

void put(Simulation& simulation, int pup, const testing::Points& points,
         const Eigen::Vector3d& velocity = {0, 0, 0}) {
  testing::place(simulation, pup, points, testing::Points(points.size(), velocity));
}

const Eigen::Matrix3d kTurned =
    Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3.5).normalized()).toRotationMatrix();

TEST(PupFields, OfALitterThatHasNotMovedYet) {
  Simulation s = litter(2, [](Params& p) { p.initial_temperature = 0.45; });
  put(s, 0, body(s, kTurned, {0, 0, 1.5}));
  put(s, 1, body(s, kTurned, {3, 0, 2}), {0.3, 0, 0.4});
  s.set_heading(1, -2);
  EXPECT_THAT(shown(s, "tb"), Each(0.45));
  EXPECT_THAT(shown(s, "felt_tb"), Each(0.45));
  EXPECT_THAT(shown(s, "exposed"), Each(1));
  EXPECT_THAT(shown(s, "huddling"), Each(0));
  EXPECT_EQ(shown(s, "heading")[1], -2);
  EXPECT_THAT(shown(s, "turn"), Each(0));
  EXPECT_THAT(shown(s, "t_left"), Each(0.4));  // T_a
  EXPECT_THAT(shown(s, "t_right"), Each(0.4));
  EXPECT_THAT(shown(s, "group"), ElementsAre(0, 1));
  EXPECT_THAT(shown(s, "group_size"), Each(1));
  EXPECT_THAT(shown(s, "neighbours"), Each(0));
  EXPECT_NEAR(shown(s, "height")[0], 1.5, 1e-12);
  EXPECT_NEAR(shown(s, "height")[1], 2, 1e-12);
  EXPECT_NEAR(shown(s, "speed")[0], 0, 1e-12);
  EXPECT_NEAR(shown(s, "speed")[1], 0.5, 1e-12);
  for (const double deformation : shown(s, "deformation")) EXPECT_NEAR(deformation, 0, 1e-12);
}

TEST(PupFields, DeformationIsTheDistanceFromTheUndeformedPup) {
  Simulation s = litter(1);
  const Eigen::Vector3d stretch(1.2, 1, 0.9);
  const Eigen::Matrix3d linear = kTurned * stretch.asDiagonal().toDenseMatrix();
  put(s, 0, body(s, linear, {0, 0, 2}));
  // kTurned is the best rotation, so what is left of a point is (stretch - 1) q.
  double squares = 0;
  for (const auto& q : cube_sphere(7, 1)) {
    squares += (stretch - Eigen::Vector3d::Ones()).cwiseProduct(q).squaredNorm();
  }
  EXPECT_NEAR(shown(s, "deformation")[0], std::sqrt(squares / 294), 1e-12);
}

TEST(PupFields, OfAPupThatStaysAlone) {
  Simulation s = litter(1, [](Params& p) { p.initial_temperature = 0.9; });
  put(s, 0, body(s, kTurned, {0, 0, 1}), {0, 0.2, 0});
  s.set_heading(0, 1);
  ASSERT_TRUE(s.step().ok());
  // dT_b/dt = G - k1 (T_b - T_a), from 0.9, over 0.01.
  const double settled = 0.4 + 0.055 / 0.9;
  EXPECT_NEAR(shown(s, "tb")[0], settled + (0.9 - settled) * std::exp(-0.9 * 0.01), 1e-15);
  EXPECT_EQ(shown(s, "felt_tb")[0], 0.9);
  EXPECT_EQ(shown(s, "exposed")[0], 1);
  EXPECT_EQ(shown(s, "huddling")[0], 0);
  EXPECT_EQ(shown(s, "heading")[0], 1);
  EXPECT_EQ(shown(s, "turn")[0], 0);
  EXPECT_EQ(shown(s, "t_left")[0], 0.4);
  EXPECT_EQ(shown(s, "t_right")[0], 0.4);
  EXPECT_EQ(shown(s, "group")[0], 0);
  EXPECT_EQ(shown(s, "group_size")[0], 1);
  EXPECT_EQ(shown(s, "neighbours")[0], 0);
  EXPECT_NEAR(shown(s, "height")[0], 1, 1e-12);
  EXPECT_NEAR(shown(s, "speed")[0], 0.2, 1e-12);
  EXPECT_NEAR(shown(s, "deformation")[0], 0, 1e-12);
}

TEST(AfferentFields, OfAPupThatStaysAlone) {
  Simulation s = litter(1);
  const testing::Points points = body(s, kTurned, {0.5, -0.5, 1});
  put(s, 0, points);
  s.set_heading(0, 1);
  ASSERT_TRUE(s.step().ok());
  EXPECT_THAT(shown(s, "temperature"), Each(0.4));
  EXPECT_THAT(shown(s, "touched"), Each(-1));
  const std::vector<double> side = shown(s, "side"), strain = shown(s, "strain");
  const std::vector<double> normal[3] = {shown(s, "normal_x"), shown(s, "normal_y"),
                                         shown(s, "normal_z")};
  const auto rest = cube_sphere(7, 0.25);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x() - 0.5, y = points[i].y() + 0.5;
    EXPECT_EQ(side[i], std::cos(1) * y - std::sin(1) * x > 0 ? 1 : 0) << i;
    EXPECT_NEAR(strain[i], 0, 1e-12) << i;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(normal[axis][i], rest[i][axis] / 0.25, 1e-12) << i;
    }
  }
}

TEST(AfferentFields, StrainIsTheDistanceFromTheGoal) {
  Simulation s = litter(1, [](Params& p) { p.deformation = 0; });
  // A body blown up by a tenth: with beta = 0 the goals are the pup at rest, turned.
  put(s, 0, body(s, 1.1 * kTurned, {0, 0, 2}));
  ASSERT_TRUE(s.step().ok());
  for (const double strain : shown(s, "strain")) EXPECT_NEAR(strain, 0.1, 1e-7);  // kept as float
  // A share alpha = 0.7 of it is gone after the step, and the points move on at that speed.
  EXPECT_NEAR(shown(s, "deformation")[0], 0.03, 1e-12);
}

/// Three pups in the air: 0 and 1 touch, 1 the lower; 2 is far away. Turned, so that no two points
/// are equally high or near.
struct InContact : ::testing::Test {
  InContact() : simulation(litter(3)) {
    const Eigen::Vector3d centres[3] = {{0, 0, 1.05}, {0.52, 0.1, 1}, {3, 0, 1}};
    const Eigen::Matrix3d other =
        Eigen::AngleAxisd(-0.7, Eigen::Vector3d(2, -1, 1).normalized()).toRotationMatrix();
    for (int pup = 0; pup < 3; ++pup) {
      placed[pup] = body(simulation, pup == 1 ? other : kTurned, centres[pup]);
      put(simulation, pup, placed[pup]);
      simulation.set_body_temperature(pup, tb[pup]);
      simulation.set_heading(pup, heading[pup]);
      touched[pup].assign(placed[pup].size(), -1);
    }
    for (std::size_t i = 0; i < placed[0].size(); ++i) {
      for (std::size_t j = 0; j < placed[1].size(); ++j) {
        if ((placed[0][i] - placed[1][j]).norm() < 0.1) touched[0][i] = 1, touched[1][j] = 0;
      }
    }
    EXPECT_TRUE(simulation.step().ok());
  }

  /// Points of `pup` that touch.
  double touching(int pup) const {
    return static_cast<double>(
        std::count_if(touched[pup].begin(), touched[pup].end(), [](int p) { return p >= 0; }));
  }

  /// Mean of T_c over the points of `pup` on one side of its heading, from the places of points.
  /// The contact stage moves pup 0 before it steers, so only pups 1 and 2 are where they were put.
  double felt(int pup, bool left) const {
    double sum = 0;
    int count = 0;
    Eigen::Vector3d centre(0, 0, 0);
    for (const auto& p : placed[pup]) centre += p / 294;
    for (std::size_t i = 0; i < placed[pup].size(); ++i) {
      const Eigen::Vector3d p = placed[pup][i] - centre;
      if ((std::cos(heading[pup]) * p.y() - std::sin(heading[pup]) * p.x() > 0) != left) continue;
      sum += touched[pup][i] < 0 ? 0.4 : tb[touched[pup][i]];
      ++count;
    }
    return sum / count;
  }

  Simulation simulation;
  testing::Points placed[3];
  std::vector<int> touched[3];
  const double tb[3] = {0.8, 0.5, 0.55}, heading[3] = {0.3, 1.2, -3};
};

TEST_F(InContact, PupsShowWhomTheyTouch) {
  ASSERT_GT(touching(0), 0);
  const std::vector<double> exposed = shown(simulation, "exposed");
  const std::vector<double> huddling = shown(simulation, "huddling");
  for (int pup = 0; pup < 3; ++pup) {
    EXPECT_DOUBLE_EQ(exposed[pup], 1 - touching(pup) / 294);
    EXPECT_DOUBLE_EQ(huddling[pup], touching(pup) / 294);
  }
  EXPECT_THAT(shown(simulation, "group"), ElementsAre(0, 0, 1));
  EXPECT_THAT(shown(simulation, "group_size"), ElementsAre(2, 2, 1));
  EXPECT_THAT(shown(simulation, "neighbours"), ElementsAre(1, 1, 0));
}

TEST_F(InContact, AfferentsFeelThePupThatTheyTouch) {
  const std::vector<double> owner = shown(simulation, "touched");
  const std::vector<double> temperature = shown(simulation, "temperature");
  for (int pup = 0; pup < 3; ++pup) {
    for (int i = 0; i < 294; ++i) {
      const int expected = touched[pup][i];
      EXPECT_EQ(owner[pup * 294 + i], expected) << pup << ' ' << i;
      EXPECT_EQ(temperature[pup * 294 + i], expected < 0 ? 0.4 : tb[expected]) << pup << ' ' << i;
    }
  }
  EXPECT_THAT(shown(simulation, "felt_tb"), ElementsAre(0.8, 0.5, 0.55));
}

TEST_F(InContact, HeatComesFromAirAndNeighbour) {
  const std::vector<double> after = shown(simulation, "tb");
  for (int pup = 0; pup < 3; ++pup) {
    const double a = 1 - touching(pup) / 294, k = 0.9 * a + 1.0 * (1 - a);
    const double neighbour = pup == 0 ? tb[1] : tb[0];
    const double settled = (0.055 + 0.9 * a * 0.4 + 1.0 * (1 - a) * neighbour) / k;
    EXPECT_NEAR(after[pup], settled + (tb[pup] - settled) * std::exp(-k * 0.01), 1e-14) << pup;
  }
}

TEST_F(InContact, SidesFeelTheMeanOfTheirPoints) {
  const std::vector<double> left = shown(simulation, "t_left");
  const std::vector<double> right = shown(simulation, "t_right");
  const std::vector<double> turn = shown(simulation, "turn");
  for (const int pup : {1, 2}) {
    const double l = felt(pup, true), r = felt(pup, false);
    EXPECT_NEAR(left[pup], l, 1e-14) << pup;
    EXPECT_NEAR(right[pup], r, 1e-14) << pup;
    const double sl = 1 / (1 + std::exp(-38 * l * (0.6 - tb[pup])));
    const double sr = 1 / (1 + std::exp(-38 * r * (0.6 - tb[pup])));
    EXPECT_NEAR(turn[pup], std::atan(200 * (sl - sr) / (sl + sr)), 1e-12) << pup;
  }
  EXPECT_GT(std::abs(turn[1]), 0.1);  // it does feel a difference
  EXPECT_EQ(turn[2], 0);
}

TEST_F(InContact, OneSideOfTheHeadingIsLeft) {
  const std::vector<double> side = shown(simulation, "side");
  int left = 0;
  for (int i = 0; i < 294; ++i) {
    const Eigen::Vector3d p = placed[1][i] - Eigen::Vector3d(0.52, 0.1, 1);
    const bool is_left = std::cos(heading[1]) * p.y() - std::sin(heading[1]) * p.x() > 0;
    EXPECT_EQ(side[294 + i], is_left ? 1 : 0) << i;
    left += is_left ? 1 : 0;
  }
  EXPECT_EQ(left, 147);
}

}  // namespace
}  // namespace pupflow
