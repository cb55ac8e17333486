#include "pupflow/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "pupflow/simulation.h"

namespace pupflow {
namespace {

TEST(Params, DefaultsAreSoundAndThePapers) {
  const Params p;
  EXPECT_TRUE(check(p).empty());
  EXPECT_EQ(p.pups, 12);
  EXPECT_EQ(points_per_pup(p), 294);
  EXPECT_EQ(p.rigidity, 0.7);
  EXPECT_EQ(p.deformation, 0.5);
}

TEST(Params, TableHoldsEveryPromisedName) {
  for (const char* name :
       {"pups",         "face_points", "arena_radius", "pup_radius", "point_radius",
        "dt",           "alpha",       "beta",         "gravity",    "drive",
        "ta",           "tp",          "k1",           "k2",         "g",
        "sigma",        "v",           "tb0",          "heading",    "start",
        "start_spread", "integrator",  "heat",         "steps",      "discard",
        "seed",         "precision"}) {
    EXPECT_NE(find_parameter(name), nullptr) << name;
  }
}

TEST(Params, RowsAreCompleteAndUnique) {
  std::set<std::string_view> names;
  for (const Parameter& row : parameters()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.title.empty() || row.doc.empty() || row.source.empty() || row.group.empty())
        << row.name;
    EXPECT_LT(row.slider_min, row.slider_max) << row.name;
    EXPECT_LE(row.min, row.slider_min) << row.name;
    EXPECT_GE(row.max, row.slider_max) << row.name;
    EXPECT_EQ(row.choices.empty(), row.kind != Parameter::Kind::choice) << row.name;
  }
}

TEST(Params, EveryRowReadsAndWritesItsOwnMember) {
  for (const Parameter& row : parameters()) {
    Params p;
    const double other = row.kind == Parameter::Kind::choice ? 1 - row.get(p) : row.get(p) + 1;
    row.set(p, other);
    EXPECT_EQ(row.get(p), other);
    for (const Parameter& another : parameters()) {
      if (another.name == row.name) continue;
      EXPECT_EQ(another.get(p), another.default_value()) << another.name;
    }
  }
}

TEST(Params, TextReadsBackToTheSameValue) {
  for (const Parameter& row : parameters()) {
    const auto round_trip = [&](double value) {
      Params p;
      Problem problem;
      ASSERT_TRUE(parse_value(row, format_value(row, value), p, problem)) << problem.message;
      EXPECT_EQ(row.get(p), value) << row.name;
    };
    round_trip(row.default_value());
    round_trip(row.kind == Parameter::Kind::real
                   ? row.slider_min + (row.slider_max - row.slider_min) / 3
                   : row.slider_max);
  }
}

TEST(Params, BadTextIsExplainedAndChangesNothing) {
  const auto explain = [](const char* name, const char* text) {
    Params p;
    Problem problem;
    EXPECT_FALSE(parse_value(*find_parameter(name), text, p, problem)) << name << " " << text;
    EXPECT_EQ(p, Params{});
    return problem.message;
  };
  EXPECT_EQ(explain("alpha", "1.5"), "alpha = 1.5: rigidity must be 0 … 1");
  EXPECT_EQ(explain("heading", "north"), "heading = 'north': heading must be course or body");
  EXPECT_EQ(explain("pups", "3.5"), "pups = 3.5: pups must be a whole number 0 … 10000");
  explain("dt", "0");
  explain("dt", "nan");
  explain("dt", "inf");
  explain("ta", "0.4x");
  explain("ta", "+-1");
  explain("ta", "");
  explain("seed", "-1");
  explain("seed", "9007199254740993000");
}

TEST(Params, AllProblemsAreListed) {
  Params p;
  p.rigidity = 2;
  p.deformation = -1;
  p.dt = std::nan("");
  p.arena_radius = 0.3;
  const auto problems = check(p);
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems[0].parameter, "alpha");
  EXPECT_EQ(problems[3].parameter, "arena_radius");
  const InvalidParams error(problems);
  EXPECT_EQ(std::string(error.what()).find(problems[0].message), 0u);
}

TEST(Params, AColumnThatReachesBeyondTheWallIsRefused) {
  Params p;
  p.start_spread = 1.4142;
  EXPECT_TRUE(check(p).empty());
  p.start_spread = 1.4143;
  const auto problems = check(p);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].parameter, "start_spread");
  EXPECT_EQ(
      problems[0].message,
      "start_spread = 1.4143: a pup may start outside the arena; start spread must be at most "
      "arena_radius / sqrt(2) = 1.414213562373095");
  EXPECT_THROW(Simulation{p}, InvalidParams);
  p.start = Start::carpet;  // does not use it
  EXPECT_TRUE(check(p).empty());
  p.start = Start::column;
  p.arena_radius = 0.44;
  p.start_spread = 0.3111269837220809;  // what a message would name
  EXPECT_TRUE(check(p).empty());
}

TEST(Params, WhatDefinesTheLitterNeedsARestart) {
  Params a, b;
  b.ambient_temperature = 0.1;
  b.steps = 9;
  EXPECT_FALSE(needs_restart(a, b));
  b.pups = 13;
  EXPECT_TRUE(needs_restart(a, b));
}

}  // namespace
}  // namespace pupflow
