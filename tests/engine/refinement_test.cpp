// What a second does to a body must not depend on the step, and at the reference step nothing may
// change.
#include "engine/refinement.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <functional>

#include "engine/cloud.h"
#include "engine/shape_match.h"
#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

/// A small deformation: a displacement for each rest offset (of point i).
using Shape = std::function<Eigen::Vector3d(std::size_t, const Eigen::Vector3d&)>;

/// A quadratic mode, which the fit represents when beta > 0.
Eigen::Vector3d bend(std::size_t, const Eigen::Vector3d& q) {
  return {0, 0, q.x() * q.y() / 0.25};
}

/// Growth in all directions, which the volume factor holds.
Eigen::Vector3d growth(std::size_t, const Eigen::Vector3d& q) {
  return q;
}

/// A mode of degree three, with what the fit could represent taken out by symmetry.
Eigen::Vector3d ripple(std::size_t, const Eigen::Vector3d& q) {
  return {q.x() * q.y() * q.z() / 0.0625, 0, 0};
}

const Eigen::Vector3d kPlace(0, 0, 5);  // far from floor and wall

/// A weightless pup, deformed a little, at rest.
Simulation deformed(const Params& params, const Shape& shape) {
  Simulation s(params);
  const auto rest = cube_sphere(params.face_points, params.pup_radius);
  Points points;
  for (std::size_t i = 0; i < rest.size(); ++i)
    points.push_back(kPlace + rest[i] + 1e-5 * shape(i, rest[i]));
  testing::place(s, 0, points, Points(rest.size(), Eigen::Vector3d::Zero()));
  return s;
}

/// How much of that deformation is there.
double amplitude(const Simulation& s, const Shape& shape) {
  const Points now = testing::all_positions(s);
  const auto rest = cube_sphere(s.params().face_points, s.params().pup_radius);
  double along = 0, all = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Eigen::Vector3d d = shape(i, rest[i]);
    along += (now[i] - kPlace - rest[i]).dot(d);
    all += d.squaredNorm();
  }
  return along / all / 1e-5;
}

struct Mode {
  const char* name;
  Eigen::Vector3d (*shape)(std::size_t, const Eigen::Vector3d&);
  double beta;
  double alpha_share;  // of alpha that the mode sees
};

const Mode kModesToTry[] = {{"bend, not fitted", bend, 0, 1},
                            {"bend, fitted", bend, 0.5, 0.5},
                            {"growth", growth, 0.5, 1},
                            {"ripple", ripple, 0.5, 1}};

Params refined(const Mode& mode, double dt) {
  Params p = testing::weightless();
  p.deformation = mode.beta;
  p.dt = dt;
  p.refinement = Refinement::consistent;
  return p;
}

TEST(Refinement, AModeTurnsAndDecaysBySecondsNotBySteps) {
  for (const Mode& mode : kModesToTry) {
    for (const Integrator integrator : {Integrator::predictive, Integrator::explicit_}) {
      const double alpha = 0.7 * mode.alpha_share;
      const bool damped = integrator == Integrator::predictive;
      const std::complex<double> lambda =
          damped ? std::complex<double>(1 - alpha, std::sqrt(alpha * (1 - alpha)))
                 : std::polar(1.0, std::acos(1 - alpha / 2));
      for (const double s : {1.0, 0.5, 0.1}) {
        Params p = refined(mode, s * kReferenceStep);
        p.integrator = integrator;
        Simulation simulation = deformed(p, mode.shape);
        double a[4];
        for (double& value : a) {
          ASSERT_TRUE(simulation.step().ok());
          value = amplitude(simulation, mode.shape);
        }
        // A mode whose steps multiply by lambda^s and its conjugate keeps this recurrence.
        const std::complex<double> step = std::pow(lambda, s);
        for (int i = 0; i < 2; ++i) {
          EXPECT_NEAR(a[i + 2], 2 * step.real() * a[i + 1] - std::norm(step) * a[i], 1e-4)
              << mode.name << " s = " << s;
        }
        EXPECT_GT(std::abs(a[0]) + std::abs(a[1]), 0.05) << mode.name;
      }
    }
  }
}

TEST(Refinement, ConvergesAtFirstOrderToTheDampedOscillator) {
  for (const Mode& mode : kModesToTry) {
    const double alpha = 0.7 * mode.alpha_share;
    const double gamma = -std::log(1 - alpha) / (2 * kReferenceStep);
    const double omega = std::acos(std::sqrt(1 - alpha)) / kReferenceStep;
    const double t = 2 * kReferenceStep;
    const double exact =
        std::exp(-gamma * t) * (std::cos(omega * t) + gamma / omega * std::sin(omega * t));
    double before = 0;
    for (int parts = 8; parts <= 1024; parts *= 2) {
      Simulation s = deformed(refined(mode, kReferenceStep / parts), mode.shape);
      ASSERT_TRUE(s.run(2 * parts).ok());
      const double error = std::abs(amplitude(s, mode.shape) - exact);
      if (parts >= 64 && parts <= 512) {
        EXPECT_NEAR(std::log2(before / error), 1, 0.08) << mode.name << " h0/" << parts;
      }
      before = error;
    }
    EXPECT_LT(before, 2e-3) << mode.name;
  }
}

TEST(Refinement, AtTheReferenceStepNothingChanges) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p;
    p.pups = 4;
    p.precision = precision;
    Simulation naive(p);
    p.refinement = Refinement::consistent;
    Simulation consistent(p);
    ASSERT_TRUE(naive.run(300).ok());
    ASSERT_TRUE(consistent.run(300).ok());
    EXPECT_EQ(naive.hash(), consistent.hash());
  }
  const StepBody body = step_body(Params{});
  EXPECT_FALSE(body.damps());
  EXPECT_EQ(body.alpha, 0.7);
  EXPECT_EQ(body.contact_share, 1);
}

/// One pup, and a step of its own without contacts, floor or wall.
struct FreeBody {
  explicit FreeBody(const Params& p, const std::function<Eigen::Vector3d(std::size_t)>& x,
                    const std::function<Eigen::Vector3d(std::size_t)>& v)
      : params(p),
        cloud(make_cloud<double>(cube_sphere(p.face_points, p.pup_radius))),
        state(make_state<double>(1, points_per_pup(p))) {
    for (int i = 0; i < state.points; ++i) {
      const Eigen::Vector3d at = x(i), speed = v(i);
      state.x[i] = at.x(), state.y[i] = at.y(), state.z[i] = at.z();
      state.vx[i] = speed.x(), state.vy[i] = speed.y(), state.vz[i] = speed.z();
    }
  }
  void step(const StepBody& body) {
    predict(params, state, 0);
    match_shapes(params, body, {params.deformation > 0, true}, cloud, state, 0, 1);
  }
  Eigen::Vector3d position(int i) const { return {state.x[i], state.y[i], state.z[i]}; }
  Eigen::Vector3d velocity(int i) const { return {state.vx[i], state.vy[i], state.vz[i]}; }

  Params params;
  Cloud<double> cloud;
  State<double> state;
};

/// Spins, bends, grows and ripples on its way through the air.
FreeBody lively(const Params& p) {
  const auto rest = cube_sphere(p.face_points, p.pup_radius);
  return FreeBody(
      p,
      [&](std::size_t i) -> Eigen::Vector3d {
        const Eigen::Vector3d& q = rest[i];
        return Eigen::Vector3d(3, 2, 1) + q + 0.1 * bend(i, q) + 0.02 * ripple(i, q);
      },
      [&](std::size_t i) -> Eigen::Vector3d {
        const Eigen::Vector3d& q = rest[i];
        return Eigen::Vector3d(1, -1, 2) + Eigen::Vector3d(1, 2, 3).cross(q) + 2 * bend(i, q) +
               3 * q + 4 * ripple(i, q);
      });
}

TEST(Refinement, KeepsMomentumAndSpinOfADeformedBody) {
  Params p = testing::weightless();
  p.refinement = Refinement::consistent;
  p.dt = 0.001;
  const auto rest = cube_sphere(p.face_points, p.pup_radius);
  const auto at = [&](std::size_t i) {
    return Eigen::Vector3d(rest[i] + 0.1 * bend(i, rest[i]) + Eigen::Vector3d(3, 2, 1));
  };
  FreeBody pup(p, at, [&](std::size_t i) {
    const Eigen::Vector3d& q = rest[i];
    return Eigen::Vector3d(Eigen::Vector3d(1, 2, 3).cross(q) + 2 * bend(i, q) + 3 * q +
                           Eigen::Vector3d(1, -1, 2));
  });
  const auto momenta = [&] {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), spin = mean;
    for (int i = 0; i < pup.state.points; ++i) {
      mean += pup.velocity(i) / pup.state.points;
      spin += (at(i) - Eigen::Vector3d(3, 2, 1)).cross(pup.velocity(i));
    }
    return std::pair(mean, spin);
  };
  const auto before = momenta();
  const double speed = pup.state.vz[0];
  StepBody damping = step_body(p);
  damping.alpha = 0;  // nothing else
  pup.step(damping);
  EXPECT_GT(std::abs(pup.state.vz[0] - speed), 1e-3);
  const auto after = momenta();
  EXPECT_LT((after.first - before.first).norm(), 1e-13);
  EXPECT_LT((after.second - before.second).norm(), 1e-12 * before.second.norm());
}

TEST(Refinement, AStepIsDampingThenPredictionThenMatching) {
  for (const double beta : {0.0, 0.5, 1.0}) {
    Params p = testing::weightless();
    p.refinement = Refinement::consistent;
    p.dt = 0.002;
    p.deformation = beta;
    const StepBody body = step_body(p);
    ASSERT_TRUE(body.damps());
    FreeBody folded = lively(p), plain = lively(p);
    folded.step(body);
    State<double>& s = plain.state;
    const ModeMatrix w = damping_goal(body, fit_modes(plain.cloud, s, 0, beta > 0),
                                      fit_velocity_modes(plain.cloud, s, 0, beta > 0));
    const Eigen::Vector3d first = plain.velocity(0);
    for (int i = 0; i < s.points; ++i) {
      Eigen::Vector3d goal = first + w.col(kMeanMode);
      for (int m = 1; m < kModes; ++m) goal += w.col(m) * plain.cloud.mode_row(m)[i];
      const Eigen::Vector3d v =
          plain.velocity(i) + (1 - body.keep_rest) * (goal - plain.velocity(i));
      s.vx[i] = v.x(), s.vy[i] = v.y(), s.vz[i] = v.z();
    }
    plain.step({body.alpha, body.beta});
    for (int i = 0; i < s.points; ++i) {
      EXPECT_LT((folded.position(i) - plain.position(i)).norm(), 1e-14) << beta;
      EXPECT_LT((folded.velocity(i) - plain.velocity(i)).norm(), 1e-12) << beta;
    }
  }
}

TEST(Refinement, HasTheSameBitsForEveryInstructionSet) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    for (const double beta : {0.0, 0.5}) {
      Params p;
      p.pups = 4;
      p.deformation = beta;
      p.dt = 0.005;
      p.precision = precision;
      p.refinement = Refinement::consistent;
      Simulation expected(p, InstructionSet::baseline);
      expected.run(300);
      for (const InstructionSet set : supported_instruction_sets()) {
        Simulation other(p, set);
        other.run(300);
        EXPECT_EQ(other.hash(), expected.hash()) << instruction_set_name(set);
      }
    }
  }
}

TEST(Refinement, RefusesWhatHasNoFinerForm) {
  Params p;
  p.refinement = Refinement::consistent;
  p.dt = 0.02;
  ASSERT_EQ(check(p).size(), 1u);
  EXPECT_NE(check(p)[0].message.find("at most 0.01"), std::string::npos) << check(p)[0].message;
  p.dt = 0.005;
  EXPECT_TRUE(check(p).empty());
  p.rigidity = 1;
  ASSERT_EQ(check(p).size(), 1u);
  EXPECT_NE(check(p)[0].message.find("alpha must be below 1"), std::string::npos);
  p.integrator = Integrator::explicit_;  // no damping, so even alpha = 1 has a limit
  EXPECT_TRUE(check(p).empty());
  p.integrator = Integrator::predictive;
  p.dt = kReferenceStep;
  EXPECT_TRUE(check(p).empty());
}

}  // namespace
}  // namespace pupflow
