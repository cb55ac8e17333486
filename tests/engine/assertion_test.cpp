// Assertions state what the engine's parts require of each other. They are checked in builds
// without NDEBUG (the presets dev, asan and tsan); elsewhere the statements here only run.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "engine/boundary.h"
#include "engine/broad_phase.h"
#include "engine/cloud.h"
#include "engine/contact.h"
#include "engine/elementary.h"

#if (defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)) && defined(NDEBUG)
#error "a build with a sanitizer must check assertions: NDEBUG must not be defined"
#endif

namespace pupflow {
namespace {

constexpr int kPoints = 54;

TEST(Assertions, BoundsThatDoNotEncloseThePoints) {
  const Params params;
  State<double> state = make_state<double>(2, kPoints);
  state.x[5] = 1;  // and no update_bounds
  Contacts<double> contacts;
  Team team;
  EXPECT_DEBUG_DEATH(contacts.find(params, {}, state, team), "all_enclosed");
  EXPECT_DEBUG_DEATH(apply_boundaries(params, state, 0), "is_enclosed");
}

TEST(Assertions, BoxesThatAreNone) {
  std::vector<Bounds<float>> boxes(2);
  boxes[1].low[2] = 1;  // above its upper side
  BroadPhase<float> broad_phase;
  EXPECT_DEBUG_DEATH(broad_phase.near_pairs(boxes, 0), "are_boxes");
  boxes[1].low[2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_DEBUG_DEATH(broad_phase.near_pairs(boxes, 0), "are_boxes");
}

TEST(Assertions, PreconditionsOfKernels) {
  const State<double> state = make_state<double>(1, kPoints);
  std::vector<double> a(64), b(64);
  EXPECT_DEBUG_DEATH(state.kernels->predict(0.1, 0, kPoints, a.data(), a.data()), "x != v");
  EXPECT_DEBUG_DEATH(state.kernels->floor(0, 4, a.data(), b.data()), "stride");
}

TEST(Assertions, RestShapesAndNumbers) {
  const std::vector<Eigen::Vector3d> lopsided{{1, 0, 0}, {1, 0, 0}};
  EXPECT_DEBUG_DEATH(make_cloud<double>(lopsided), "is_mirrored");
  EXPECT_DEBUG_DEATH(wrap_angle(std::numeric_limits<double>::infinity()), "isfinite");
  EXPECT_DEBUG_DEATH(inverse_cbrt_fixed(0), "min");
}

}  // namespace
}  // namespace pupflow
