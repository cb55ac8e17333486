// Any commands in any order.
#include <gmock/gmock.h>

#include <random>
#include <string>

#include "tests/window/session_words.h"

namespace pupflow::window {
namespace {

/// One command of any kind, with numbers that make sense, mostly.
Command any_command(std::mt19937& random, const Params& params, std::int64_t last) {
  const auto below = [&](std::int64_t n) { return static_cast<std::int64_t>(random() % n); };
  const auto share = [&] { return static_cast<double>(random() % 1001) / 1000; };
  const char* const names[] = {"ta", "tp", "alpha", "beta", "gravity", "drive", "k1", "dt"};
  const auto any_name = [&] { return names[below(std::size(names))]; };
  struct Value {  // in braces, so that every compiler draws the name first
    const char* name;
    double value;
  };
  const auto changed = [&](Value asked) {
    Params next = params;
    find_parameter(asked.name)->set(next, asked.value);
    return next;
  };
  switch (below(16)) {
    case 0:
    case 1:
      return GoTo{below(last + 1)};
    case 2:
    case 3:
      return Edit{changed({any_name(), share()}), params, below(2) == 0};
    case 4:
      return Edit{changed({"dt", 0.002 + 0.01 * share()}), params};
    case 5:
      return below(4) == 0 ? Edit{changed({"pups", 2.0 + static_cast<double>(below(3))}), params}
                           : Edit{changed({"heading", static_cast<double>(below(2))}), params};
    case 6:
      return RampTo{place(any_name()), share(), 1 + below(80), below(2) == 0};
    case 7:
    case 8:
      return below(3) == 0 ? Pull{} : Pull{static_cast<int>(below(4)), {share(), -share(), 0.4}};
    case 9:
      return SwapFuture{};
    case 10:
    case 11:
      return Undo{};
    case 12:
      return Redo{};
    case 13:
      return below(3) == 0 ? Command{Restart{}} : Command{Advance{below(30)}};
    case 14:
      return below(2) == 0 ? Compare{}
                           : Compare{changed({any_name(), 0.1 + share()}), below(2) == 0};
    default:
      return below(2) == 0 ? Command{Watch{}}
                           : Command{Watch{.parts = {Part::strain, Part::sides}}};
  }
}

/// Begins with a seed of the commands' order.
class AnyTimeline : public testing::TestWithParam<unsigned> {};

TEST_P(AnyTimeline, IsThatOfARecipe) {
  Params params = small_litter();
  params.schedule.add(
      {.step = 100, .until = 160, .settings = {{place("ta"), 0.8}}, .pup = {}, .action = {}});
  std::mt19937 random(GetParam());
  Session session(params, true);
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE("command " + std::to_string(i));
    const LiveState before = look_at(session);
    have(session, any_command(random, session.params(), before.timeline.last));
    const bool good = look_at(session).status.ok();
    for (auto steps = random() % 40; steps > 0 && good; --steps) session.step();
    const LiveState state = look_at(session);
    ASSERT_LE(state.view().step, state.timeline.last);
    ASSERT_LE(state.history.last(), state.timeline.last);
    for (const Timeline::Mark& mark : state.timeline.marks) {
      ASSERT_LE(mark.step, state.timeline.last) << mark.text;
    }
    if (!state.status.ok()) {
      have(session, GoTo{state.timeline.last / 2});
      continue;
    }
    ASSERT_EQ(state.hash, headless(state));
    if (!state.second || !state.second->status.ok()) continue;
    ASSERT_EQ(state.second->view().step, state.view().step);
    Simulation second(state.second->view().recipe);
    second.run(state.second->view().step);
    const LitterView expected = second.view();
    ASSERT_TRUE(
        std::equal(expected.tb.begin(), expected.tb.end(), state.second->view().tb.begin()));
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, AnyTimeline, testing::Range(1u, 21u));

}  // namespace
}  // namespace pupflow::window
