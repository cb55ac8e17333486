#include "app/window/session/runner.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <semaphore>
#include <thread>

namespace pupflow::window {
namespace {

using namespace std::chrono_literals;

Params small_litter() {
  Params params;
  params.pups = 2;
  params.face_points = 3;
  params.seed = 5;
  return params;
}

/// A runner and the window's side of it.
class Watched {
 public:
  explicit Watched(bool playing, const Params& params = small_litter())
      : runner_(
            {.params = params, .playing = playing, .notify = [this] { published_.release(); }}) {}

  Runner& operator*() { return runner_; }
  Runner* operator->() { return &runner_; }

  /// The next snapshot; fails the test when none comes.
  const LiveState& next() {
    runner_.request();
    EXPECT_TRUE(published_.try_acquire_for(60s)) << "no snapshot came";
    EXPECT_TRUE(runner_.take());
    return runner_.snapshot();
  }

  /// The first snapshot for which `wanted` holds, of many.
  const LiveState& await(const std::function<bool(const LiveState&)>& wanted) {
    const auto give_up = std::chrono::steady_clock::now() + 60s;
    while (!wanted(next())) {
      if (std::chrono::steady_clock::now() > give_up) {
        ADD_FAILURE() << "the snapshot waited for never came";
        break;
      }
    }
    return runner_.snapshot();
  }

  bool nothing_published() { return !published_.try_acquire(); }

 private:
  std::counting_semaphore<> published_{0};
  Runner runner_;
};

TEST(Runner, ShowsTheStartWithoutAStep) {
  Watched runner(false);
  const LiveState& snapshot = runner.next();
  EXPECT_EQ(snapshot.view().step, 0);
  EXPECT_FALSE(snapshot.playing);
  EXPECT_EQ(snapshot.hash, Simulation(small_litter()).hash());
}

TEST(Runner, StepsByItselfWhilePlaying) {
  Watched runner(true);
  const std::int64_t first = runner.next().view().step;
  const LiveState& later =
      runner.await([&](const LiveState& s) { return s.view().step >= first + 5; });
  EXPECT_TRUE(later.playing);
  EXPECT_FALSE(later.hash) << "a litter that plays is hashed when it is wanted";
  runner->send(Hash{});
  const LiveState& hashed = runner.await([](const LiveState& s) { return s.hash.has_value(); });
  Simulation simulation(small_litter());
  simulation.run(hashed.view().step);
  EXPECT_EQ(hashed.hash, simulation.hash());
  EXPECT_FALSE(runner.next().hash);
}

TEST(Runner, PausedAndUnchangedItPublishesNothing) {
  Watched runner(false);
  runner.next();
  runner->request();  // stays open until something changes
  runner->send(Advance{1});
  EXPECT_EQ(runner.next().view().step, 1);
  EXPECT_TRUE(runner.nothing_published());
}

TEST(Runner, PauseHoldsTheLitterStill) {
  Watched runner(true);
  runner->send(Speed{std::numeric_limits<double>::infinity()});
  runner.await([](const LiveState& s) { return s.view().step > 10; });
  runner->send(PlayPause{});
  const LiveState& paused = runner.await([](const LiveState& s) { return !s.playing; });
  const std::int64_t step = paused.view().step;
  EXPECT_EQ(paused.steps_per_second, 0);
  runner->send(Advance{1});
  EXPECT_EQ(runner.next().view().step, step + 1);
}

TEST(Runner, ManyStepsAreThoseOfASimulation) {
  Watched runner(false);
  runner->send(Advance{250});
  const LiveState& snapshot = runner.await([](const LiveState& s) { return s.view().step == 250; });
  Simulation simulation(small_litter());
  simulation.run(250);
  EXPECT_EQ(snapshot.hash, simulation.hash());
  EXPECT_GT(snapshot.microseconds_per_step, 0);
}

TEST(Runner, ASnapshotThatIsNotTakenYetHasWhatACommandBrings) {
  std::counting_semaphore<> told{0};
  Runner runner({.params = small_litter(), .playing = false, .notify = [&] { told.release(); }});
  runner.request();
  ASSERT_TRUE(told.try_acquire_for(60s));
  Params edited = small_litter();
  edited.ambient_temperature = 0.3;
  runner.send(Edit{edited});
  const auto give_up = std::chrono::steady_clock::now() + 60s;
  while (runner.commands_to_come() && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(1ms);
  }
  ASSERT_TRUE(runner.take());
  EXPECT_EQ(runner.snapshot().view().params.ambient_temperature, 0.3);
  EXPECT_FALSE(told.try_acquire()) << "that there is one was told before";
  EXPECT_FALSE(runner.take());
}

TEST(Runner, OfEditsInARowTheLastOneCounts) {
  Watched runner(false);
  Params edited = small_litter();
  for (const double ta : {0.1, 0.2, 0.3}) {
    edited.ambient_temperature = ta;
    runner->send(Edit{edited});
  }
  runner->send(Advance{1});
  const LiveState& snapshot = runner.await([](const LiveState& s) { return s.view().step == 1; });
  EXPECT_EQ(snapshot.view().params.ambient_temperature, 0.3);
  Simulation simulation(edited);
  simulation.run(1);
  EXPECT_EQ(snapshot.hash, simulation.hash());
}

TEST(Runner, OfADragOverTheTimelineTheLastPlaceCounts) {
  Watched runner(false);
  runner->send(Advance{1000});
  runner.await([](const LiveState& s) { return s.view().step == 1000; });
  for (std::int64_t step = 1000; step > 137; --step) runner->send(GoTo{step});
  runner->send(GoTo{137});
  const LiveState& there = runner.await([](const LiveState& s) { return s.view().step == 137; });
  Simulation simulation(small_litter());
  simulation.run(137);
  EXPECT_EQ(there.hash, simulation.hash());
  EXPECT_EQ(there.timeline.last, 1000);
  EXPECT_FALSE(there.playing);
}

TEST(Runner, ADragOfASliderIsOneEdit) {
  Watched runner(false);
  Params before = small_litter();
  for (const double ta : {0.1, 0.2, 0.3, 0.35}) {
    Params edited = before;
    edited.ambient_temperature = ta;
    runner->send(Edit{edited, before, ta != 0.1});
    before = edited;
  }
  runner->send(Undo{});
  const LiveState& undone = runner.await([](const LiveState& s) { return s.timeline.can_redo; });
  EXPECT_EQ(undone.view().params, small_litter());
  EXPECT_FALSE(undone.timeline.can_undo);
}

TEST(Runner, AnEditInTheMiddleOfARunIsTaken) {
  Watched runner(true);
  runner.await([](const LiveState& s) { return s.view().step > 2; });
  Params edited = small_litter();
  edited.ambient_temperature = 0.9;
  runner->send(Edit{edited});
  const LiveState& snapshot =
      runner.await([](const LiveState& s) { return s.view().params.ambient_temperature == 0.9; });
  const auto changes = snapshot.view().recipe.schedule.changes();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_GT(changes[0].step, 2);
  EXPECT_TRUE(snapshot.playing);
}

TEST(Runner, ABadStatusIsPublishedAndPauses) {
  Params params;
  params.pups = 1;
  params.heat = HeatRule::euler;
  params.air_conductance = 500;
  Watched runner(true, params);
  runner->send(Speed{std::numeric_limits<double>::infinity()});
  const LiveState& snapshot = runner.await([](const LiveState& s) { return !s.status.ok(); });
  EXPECT_FALSE(snapshot.playing);
  EXPECT_EQ(snapshot.status.kind, Status::Kind::diverged);
  const std::int64_t last = snapshot.timeline.last;
  runner->send(GoTo{last - 1});
  const LiveState& back =
      runner.await([&](const LiveState& s) { return s.view().step == last - 1; });
  EXPECT_TRUE(back.status.ok());
}

TEST(Runner, EndsWhileItRuns) {
  for (const bool playing : {false, true}) {
    Watched runner(playing);
    runner->send(Speed{std::numeric_limits<double>::infinity()});
    runner.next();
  }
}

TEST(Runner, RefusesUnsoundParameters) {
  Params params = small_litter();
  params.dt = -1;
  EXPECT_THROW(Watched runner(false, params), InvalidParams);
}

}  // namespace
}  // namespace pupflow::window
