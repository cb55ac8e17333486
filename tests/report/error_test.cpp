// The error report's scenes in their quick form: orders of convergence, references that have
// converged, and what does not converge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/report/error/rotations.h"
#include "app/report/error/sampling.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"
#include "engine/rotation.h"
#include "pupflow/simulation.h"

namespace pupflow::report {
namespace {

SceneResult quick(const ErrorScene& scene) {
  Options options;
  options.quick = true;
  options.quiet = true;
  return measure(scene, options);
}

const MeasuredCurve& curve(const SceneResult& result, const std::string& name) {
  const auto found = std::find_if(result.curves.begin(), result.curves.end(),
                                  [&](const MeasuredCurve& c) { return c.name == name; });
  if (found == result.curves.end()) throw std::out_of_range("no curve " + name);
  return *found;
}

/// The order between the last two settings of a curve.
double order(const SceneResult& result, const std::string& name, std::size_t quantity) {
  return curve(result, name).points.back().orders[quantity];
}

double last_error(const SceneResult& result, const std::string& name, std::size_t quantity) {
  return curve(result, name).points.back().errors[quantity];
}

void expect_converged_reference(const SceneResult& result) {
  for (const double change : result.reference_change) EXPECT_LT(change, 0.01);
}

TEST(ErrorReport, FallAndLandingConvergeAtFirstOrder) {
  const SceneResult result = quick(fall_scene(true));
  expect_converged_reference(result);
  for (const std::size_t quantity : {0, 1}) {
    EXPECT_NEAR(order(result, "consistent", quantity), 1, 0.1);
  }
  EXPECT_GT(order(result, "consistent", 2), 1);
  // In one step gravity moves the pup by g h^2 where g h^2 / 2 is right: g h t / 2 in all.
  EXPECT_NEAR(result.standard.errors[0], 0.05, 0.005);
  // A naively refined body is another one: its landing never comes near.
  EXPECT_GT(last_error(result, "naive", 1), 0.1);
}

TEST(ErrorReport, SpinConvergesAtFirstOrderAndTheExplicitFormKeepsMomentum) {
  const SceneResult result = quick(spin_scene(true));
  expect_converged_reference(result);
  for (const std::size_t quantity : {0, 1}) {
    EXPECT_NEAR(order(result, "consistent", quantity), 1, 0.15);
  }
  EXPECT_LT(last_error(result, "explicit", 0), 1e-12);
  // One rotation is as good as the other, but not one that is still under way.
  const std::vector<Measured>& routines = result.asides.at(0);
  for (const std::size_t exact : {0, 1, 2}) EXPECT_LT(routines[exact].errors[1], 1e-9);
  EXPECT_GT(routines[3].errors[0], routines[4].errors[0]);
  EXPECT_GT(routines[4].errors[0], routines[5].errors[0]);
  EXPECT_GT(routines[5].errors[0], 0.01);
}

TEST(ErrorReport, ASqueezedPupFollowsTheLinearResponseAtFirstOrder) {
  const SceneResult result = quick(squeeze_scene(true));
  for (const std::size_t quantity : {0, 1, 2}) {
    EXPECT_NEAR(order(result, "consistent", quantity), 1, 0.05);
    EXPECT_GT(last_error(result, "naive", quantity),
              7 * last_error(result, "consistent", quantity));
    EXPECT_GT(last_error(result, "explicit", quantity), 0.5);
    // Of the amplitude at first, which a mode does not exceed.
    EXPECT_LT(result.standard.errors[quantity], 0.1);
  }
}

TEST(ErrorReport, HeatIsExactOrOfFirstOrder) {
  const SceneResult result = quick(cooling_scene(true));
  for (const double error : result.standard.errors) EXPECT_LT(error, 1e-14);
  for (const std::size_t quantity : {0, 1}) {
    EXPECT_NEAR(order(result, "Euler", quantity), 1, 0.05);
  }
  EXPECT_FALSE(last_error(result, "Euler", 2) < 1e100) << "a rate of 10^4 is far beyond 2/h";
  // What the paper's step is charged with is no other refinement.
  for (const Measured& point : curve(result, "Euler").points) {
    EXPECT_EQ(point.setting.params.refinement, Refinement::naive);
  }
}

TEST(ErrorReport, ReferencesAreComparedWithEachOther) {
  const SceneResult result = quick(fall_scene(true));
  EXPECT_EQ(result.reference_difference[0], 0) << "a closed form";
  for (const std::size_t quantity : {1, 2}) {
    EXPECT_GT(result.reference_difference[quantity], 0);
    EXPECT_LT(result.reference_difference[quantity],
              0.01 * last_error(result, "consistent", quantity));
  }
}

TEST(ErrorReport, WhatASceneDoesBetweenStepsIsNotTimed) {
  Params params;
  params.pups = 1;
  Simulation simulation(params);
  double between = 0;
  const Outcome outcome = run_sampled(
      simulation, 3, 1, [](const LitterView&, Trajectory& to) { to[0].push_back(0); },
      [&](Simulation&) {
        const double begin = thread_seconds();
        while (thread_seconds() - begin < 2e-3) {
        }
        between += 2e-3;
      });
  EXPECT_LT(outcome.seconds * 3 * kSample, 0.5 * between);
}

TEST(ErrorReport, PressedPupsConvergeSlowly) {
  const SceneResult result = quick(press_scene(true));
  expect_converged_reference(result);
  EXPECT_GT(order(result, "consistent", 0), 0.5);
  EXPECT_LT(last_error(result, "consistent", 0), result.standard.errors[0]);
  EXPECT_LT(last_error(result, "consistent", 2), 0.4 * result.standard.errors[2]);
  EXPECT_GT(last_error(result, "naive", 2), 0.4);
}

TEST(ErrorReport, ErrorsAreRelativeRootMeanSquares) {
  const std::vector<double> errors =
      errors_of({{1, 2, 3}, {0, 4}, {0, 4}}, {{1, 2, 5}, {3, 4}, {3, 4}},
                {{"one", "one"}, {"two", "two"}, {"sized", "sized", 2}});
  EXPECT_DOUBLE_EQ(errors[0], std::sqrt(4.0 / 30));
  EXPECT_DOUBLE_EQ(errors[1], 3.0 / 5);
  EXPECT_DOUBLE_EQ(errors[2], std::sqrt(9.0 / 8));
}

TEST(Rotations, AllRoutinesFindTheSameRotationInTheEnd) {
  Eigen::Matrix3d stretch;
  stretch << 1.2, 0.1, 0, 0.1, 0.9, 0.05, 0, 0.05, 1.1;
  const Eigen::Matrix3d a = 3 * oblique_rotation() * stretch;
  const Eigen::Matrix3d right = nearest_rotation(a).matrix;
  for (const Routine routine : {Routine::engine, Routine::svd, Routine::closed_form, Routine::horn,
                                Routine::mueller_1, Routine::mueller_3, Routine::mueller_5}) {
    RotationFinder find(routine);
    find(Eigen::Matrix3d::Identity());  // where Müller's start from
    Eigen::Matrix3d found;
    for (int i = 0; i < 60; ++i) found = find(a);
    EXPECT_LT((found - right).norm(), 1e-9) << static_cast<int>(routine);
  }
}

}  // namespace
}  // namespace pupflow::report
