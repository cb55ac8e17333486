// What tests of a session ask of it, and what they look at.
#pragma once

#include <gtest/gtest.h>

#include "app/window/session/session.h"

namespace pupflow::window {

inline Params small_litter() {
  Params params;
  params.pups = 3;
  params.face_points = 3;
  params.seed = 11;
  return params;
}

/// Heat by forward Euler far outside its region: the status turns bad within some steps.
inline Params runaway() {
  Params params;
  params.pups = 2;
  params.heat = HeatRule::euler;
  params.air_conductance = 500;
  return params;
}

inline std::size_t place(std::string_view name) {
  return static_cast<std::size_t>(find_parameter(name) - parameters().data());
}

inline LiveState look_at(Session& session) {
  LiveState state;
  session.apply(Hash{});
  session.fill(state);
  return state;
}

inline void play(Session& session, int steps) {
  for (int i = 0; i < steps; ++i) session.step();
}

/// Has the command carried out, and the litter go where it sends it.
inline void have(Session& session, const Command& command) {
  session.apply(command);
  while (session.hurried()) session.step();
}

inline void set(Session& session, std::string_view name, double value, bool continues = false) {
  const Params before = session.params();
  Params params = before;
  find_parameter(name)->set(params, value);
  have(session, Edit{params, before, continues});
}

inline double value(Session& session, std::string_view name) {
  return find_parameter(name)->get(session.params());
}

/// What the recipe comes to without any window.
inline std::uint64_t headless(const LiveState& state) {
  Simulation again(state.view().recipe);
  again.run(state.view().step);
  EXPECT_FALSE(again.edited());
  return again.hash();
}

}  // namespace pupflow::window
