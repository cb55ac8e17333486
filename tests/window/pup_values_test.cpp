#include "app/window/pup_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/window/selection.h"
#include "pupflow/simulation.h"

namespace pupflow::window {
namespace {

/// A huddle of which everything is recorded.
Simulation huddle(int steps) {
  Params params;
  params.pups = 5;
  params.arena_radius = 0.9;
  Simulation simulation(params);
  simulation.set_observed(PartSet::all());
  simulation.run(steps);
  return simulation;
}

void expect_same(double a, double b, const std::string& what) {
  if (std::isnan(b)) {
    EXPECT_TRUE(std::isnan(a)) << what;
  } else {
    EXPECT_EQ(a, b) << what;
  }
}

TEST(PupValues, AreThoseOfTheWholeLitter) {
  const Simulation litter = huddle(80);
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      const std::vector<double> all = field.values(litter);
      for (int pup = 0; pup < litter.pups(); ++pup) {
        const std::vector<double> own = values_of(field, litter, pup);
        ASSERT_EQ(own.size() * litter.pups(), all.size()) << field.name;
        for (std::size_t i = 0; i < own.size(); ++i) {
          expect_same(own[i], all[static_cast<std::size_t>(pup) * own.size() + i],
                      std::string(field.name));
        }
      }
    }
  }
}

TEST(PupValues, AreUnknownWhereNothingWasRecorded) {
  Params params;
  params.pups = 3;
  Simulation litter(params);
  litter.set_observed({});
  litter.run(3);
  EXPECT_TRUE(std::isnan(values_of(*find_field("t_left"), litter, 1).front()));
  EXPECT_TRUE(std::isnan(values_of(*find_field("group"), litter, 1).front()));
  EXPECT_TRUE(touched_by(litter, 1).empty());
  const Watch watch = recorded_for(*find_field("strain"));
  litter.set_observed(watch.parts);
  litter.run(1);
  for (const LitterField& field : pup_fields()) {
    EXPECT_TRUE(std::isfinite(values_of(field, litter, 1).front())) << field.name;
  }
  EXPECT_TRUE(std::isfinite(values_of(*find_field("strain"), litter, 2).front()));
  EXPECT_TRUE(watch.velocities);
}

TEST(PupValues, TouchesAreMutualAndTheirPointsAreCounted) {
  const Simulation simulation = huddle(80);
  const LitterView litter = simulation.view();
  int pairs = 0, points = 0;
  for (int pup = 0; pup < litter.pups; ++pup) {
    for (const Touch& touch : touched_by(litter, pup)) {
      ++pairs;
      points += touch.points;
      const auto back = touched_by(litter, touch.pup);
      EXPECT_TRUE(std::ranges::any_of(back, [&](const Touch& one) { return one.pup == pup; }));
    }
  }
  EXPECT_GT(pairs, 0);
  EXPECT_EQ(pairs, 2 * static_cast<int>(litter.touching.size()));
  EXPECT_EQ(points, std::ranges::count_if(litter.touched, [](int pup) { return pup >= 0; }));
}

TEST(PupValues, CurvesAreBoundedAndFollowGoingBack) {
  Simulation simulation = huddle(0);
  PupCurves curves;
  const std::size_t kMore = 3 * PupCurves::kSamples;
  const Simulation start = simulation;
  for (std::size_t i = 0; i < kMore; ++i) {
    simulation.step();
    curves.add(simulation, 2);
    curves.add(simulation, 2);
  }
  EXPECT_LE(curves.samples().size(), PupCurves::kSamples);
  EXPECT_GT(curves.samples().size(), PupCurves::kSamples / 3);
  EXPECT_EQ(curves.samples().back().step, simulation.steps_done());
  EXPECT_EQ(curves.samples().front().step, 1) << "the whole time";
  for (std::size_t i = 1; i < curves.samples().size(); ++i) {
    EXPECT_LE(curves.samples()[i].step - curves.samples()[i - 1].step, 8);
  }
  EXPECT_EQ(curves.samples().back().values.front(), simulation.view().tb[2]);

  Simulation earlier = start;
  earlier.run(100);
  curves.add(earlier, 2);
  EXPECT_EQ(curves.samples().back().step, 100);
  EXPECT_LE(curves.samples().size(), 100u);
  EXPECT_GT(curves.samples().size(), 10u);
  curves.add(earlier, 3);
  EXPECT_EQ(curves.samples().size(), 1u) << "another pup";
}

TEST(Selection, GoesRoundAndRound) {
  EXPECT_EQ(next_pup({}, 3, 1), 0);
  EXPECT_EQ(next_pup({}, 3, -1), 2);
  EXPECT_EQ(next_pup(2, 3, 1), 0);
  EXPECT_EQ(next_pup(0, 3, -1), 2);
  EXPECT_EQ(next_pup(0, 1, 1), 0);
  EXPECT_EQ(next_pup(0, 1, -1), 0);
}

TEST(Selection, TheEyeIsInFrontOfTheBodyAndLooksAlongItsHeading) {
  const Simulation simulation = huddle(120);
  const LitterView litter = simulation.view();
  for (int pup = 0; pup < litter.pups; ++pup) {
    const view::Camera camera = eye_of(litter, pup);
    const double heading = litter.heading[static_cast<std::size_t>(pup)];
    const Eigen::Vector3d along(std::cos(heading), std::sin(heading), 0);
    EXPECT_LT((camera.backward() + along).norm(), 1e-9);
    for (int i = 0; i < litter.points; ++i) {
      EXPECT_GT((camera.eye() - litter.positions(pup, i)).dot(along), litter.params.point_radius);
    }
  }
}

TEST(Selection, LookingOutOfAPupsEyesEndsWhereItBegan) {
  const Simulation litter = huddle(10);
  const view::Camera usual = view::Camera::parse("orbit:30,35,9");
  CameraGuide guide;
  view::Camera camera = guide.lead(usual, CameraMode::free, 1, litter);
  EXPECT_EQ(camera, usual);
  camera = guide.lead(camera, CameraMode::eye, 1, litter);
  EXPECT_EQ(camera, eye_of(litter, 1));
  camera = guide.lead(camera, CameraMode::eye, 2, litter);
  EXPECT_EQ(camera, eye_of(litter, 2));
  camera = guide.lead(camera, CameraMode::free, 2, litter);
  EXPECT_EQ(camera, usual);
  camera = guide.lead(camera, CameraMode::follow, 2, litter);
  EXPECT_EQ(camera.target(), *middle_of(litter, 2));
  EXPECT_EQ(camera.distance(), usual.distance());
  camera = guide.lead(camera, CameraMode::follow, 9, litter);
  EXPECT_EQ(camera.target(), *middle_of(litter, 2)) << "a pup that is not there moves nothing";
}

TEST(Selection, TheMarkIsAroundThePupWithItsNumber) {
  const Simulation simulation = huddle(60);
  const LitterView litter = simulation.view();
  const view::Camera camera = view::Camera::parse("orbit:30,35,9");
  view::Marks marks;
  mark_pup(litter, 3, camera, marks);
  const Eigen::Vector3d middle = *middle_of(litter, 3);
  double reach = 0;
  for (int i = 0; i < litter.points; ++i) {
    reach = std::max(reach, (litter.positions(3, i) - middle).norm());
  }
  int rings = 0, labels = 0;
  for (const view::Mark& mark : marks.marks) {
    if (const auto* ring = std::get_if<view::Polyline>(&mark)) {
      ++rings;
      for (const Eigen::Vector3d& point : ring->points) {
        EXPECT_GT((point - middle).norm(), reach);
        EXPECT_LT((point - middle).norm(), 1.5 * reach);
        EXPECT_NEAR((point - middle).dot(camera.backward()), 0, 1e-9);
      }
    }
    if (const auto* label = std::get_if<view::Label>(&mark)) {
      ++labels;
      EXPECT_EQ(label->text.front().text, "3");
    }
  }
  EXPECT_EQ(rings, 2);
  EXPECT_EQ(labels, 1);
}

TEST(Selection, APupWithBadNumbersIsWhereItsGoodPointsAre) {
  Params params;
  params.pups = 2;
  Simulation simulation(params);
  std::vector<double> xyz(static_cast<std::size_t>(3 * simulation.points())), still(xyz.size());
  std::fill(xyz.begin(), xyz.end(), std::nan(""));
  simulation.set_cloud(1, xyz, still);
  EXPECT_EQ(middle_of(simulation, 1), std::nullopt);
  view::Marks marks;
  mark_pup(simulation, 1, view::Camera::parse("top"), marks);
  EXPECT_TRUE(marks.marks.empty());
  xyz[0] = 0.5, xyz[1] = 0.25, xyz[2] = 0.125;
  simulation.set_cloud(1, xyz, still);
  EXPECT_EQ(middle_of(simulation, 1), Eigen::Vector3d(0.5, 0.25, 0.125));
}

}  // namespace
}  // namespace pupflow::window
