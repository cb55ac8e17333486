#include "app/window/session/redraw_schedule.h"

#include <gmock/gmock.h>

namespace pupflow::window {
namespace {

using Schedule = RedrawSchedule;

constexpr double kTick = 1e-3;  // less than every interval of the schedule
constexpr bool kSlow = true;    // the processor draws

/// Draws one frame, in which nothing happens.
void draw(Schedule& schedule, double now) {
  schedule.begin_frame(now);
  schedule.end_frame();
}

/// Asks for a snapshot, gets it and draws it.
void show_snapshot(Schedule& schedule, double now) {
  schedule.snapshot_requested();
  schedule.snapshot_arrived(now);
  draw(schedule, now);
}

/// A schedule whose first snapshot was drawn at 0; the second one was requested and never comes, as
/// while the run is paused.
Schedule paused(bool slow_gl = false) {
  Schedule schedule(slow_gl);
  show_snapshot(schedule, 0);
  schedule.snapshot_requested();
  return schedule;
}

/// Frames drawn while the clock goes from `from` to `to` in ticks.
int frames_between(Schedule& schedule, double from, double to) {
  int frames = 0;
  for (int i = 0; from + i * kTick < to; ++i) {
    const double now = from + i * kTick;
    if (!schedule.frame_due(now)) continue;
    draw(schedule, now);
    ++frames;
  }
  return frames;
}

TEST(RedrawSchedule, BeforeTheFirstSnapshotNoFrameIsDue) {
  Schedule schedule(false);
  EXPECT_TRUE(schedule.wants_snapshot(0));
  EXPECT_EQ(schedule.sleep(0), 0);
  schedule.snapshot_requested();
  schedule.event();
  EXPECT_FALSE(schedule.frame_due(1));
  EXPECT_EQ(schedule.sleep(1), Schedule::kLongestSleep);
}

TEST(RedrawSchedule, ASnapshotIsDrawnOnce) {
  Schedule schedule(false);
  EXPECT_FALSE(schedule.fresh());
  schedule.snapshot_requested();
  schedule.snapshot_arrived(1);
  EXPECT_TRUE(schedule.frame_due(1));
  EXPECT_EQ(schedule.sleep(1), 0);
  schedule.begin_frame(1);
  EXPECT_TRUE(schedule.fresh());
  schedule.end_frame();
  EXPECT_FALSE(schedule.fresh());
  EXPECT_FALSE(schedule.frame_due(100));
}

TEST(RedrawSchedule, WithNothingToShowItSleepsAndDrawsNothing) {
  for (const bool slow_gl : {false, kSlow}) {
    Schedule schedule = paused(slow_gl);
    frames_between(schedule, 0, 1);
    EXPECT_EQ(frames_between(schedule, 1, 10), 0);
    EXPECT_FALSE(schedule.wants_snapshot(10));
    EXPECT_EQ(schedule.sleep(10), Schedule::kLongestSleep);
  }
}

TEST(RedrawSchedule, OneSnapshotIsRequestedAtATime) {
  Schedule schedule(false);
  schedule.snapshot_requested();
  EXPECT_FALSE(schedule.wants_snapshot(100));
  schedule.snapshot_arrived(100);
  EXPECT_TRUE(schedule.wants_snapshot(100));
}

TEST(RedrawSchedule, TheNextSnapshotIsRequestedOneIntervalAfterTheLastWasDrawn) {
  Schedule schedule(false);
  show_snapshot(schedule, 2);
  EXPECT_FALSE(schedule.wants_snapshot(2 + 0.9 * Schedule::kSnapshotInterval));
  EXPECT_NEAR(schedule.sleep(2), Schedule::kSnapshotInterval, 1e-9);
  const double later = 2 + 1.01 * Schedule::kSnapshotInterval;
  EXPECT_TRUE(schedule.wants_snapshot(later));
  EXPECT_EQ(schedule.sleep(later), 0);
}

TEST(RedrawSchedule, FramesOfThePanelsDoNotDelaySnapshots) {
  Schedule schedule(false);
  show_snapshot(schedule, 0);
  const double later = 1.01 * Schedule::kSnapshotInterval;
  for (double now = 0; now < later; now += kTick) {
    schedule.event();
    draw(schedule, now);
  }
  EXPECT_TRUE(schedule.wants_snapshot(later));
}

TEST(RedrawSchedule, AnEventIsFollowedByAFewFramesAtOnce) {
  Schedule schedule = paused();
  schedule.event();
  EXPECT_EQ(schedule.sleep(1), 0);
  EXPECT_EQ(frames_between(schedule, 1, 9), Schedule::kFramesPerEvent);
}

TEST(RedrawSchedule, EventsDoNotAddUpTheirFrames) {
  Schedule schedule = paused();
  for (int i = 0; i < 10; ++i) schedule.event();
  EXPECT_EQ(frames_between(schedule, 1, 9), Schedule::kFramesPerEvent);
}

TEST(RedrawSchedule, PanelsThatChangeInAFrameAreDrawnInTheNextOne) {
  Schedule schedule = paused();
  schedule.begin_frame(1);
  schedule.panels_changed();
  schedule.end_frame();
  EXPECT_EQ(frames_between(schedule, 1, 9), 1);

  schedule.event();
  schedule.panels_changed();
  EXPECT_EQ(frames_between(schedule, 10, 19), Schedule::kFramesPerEvent) << "none is lost";
}

TEST(RedrawSchedule, AHiddenWindowNeitherDrawsNorAsksForSnapshots) {
  Schedule schedule(false);
  show_snapshot(schedule, 0);
  schedule.set_visible(false);
  schedule.event();
  EXPECT_FALSE(schedule.visible());
  EXPECT_FALSE(schedule.frame_due(5));
  EXPECT_FALSE(schedule.wants_snapshot(5));
  EXPECT_EQ(schedule.sleep(5), Schedule::kLongestSleep);
}

TEST(RedrawSchedule, AHiddenWindowThatFilmsAsksForSnapshotsAndDrawsNothing) {
  Schedule schedule(false);
  show_snapshot(schedule, 0);
  schedule.set_visible(false);
  schedule.set_filming(true);
  EXPECT_TRUE(schedule.wants_snapshot(5));
  EXPECT_EQ(schedule.sleep(5), 0);
  EXPECT_FALSE(schedule.frame_due(5));
  schedule.snapshot_requested();
  EXPECT_EQ(schedule.sleep(5), Schedule::kLongestSleep);
  schedule.set_filming(false);
  EXPECT_FALSE(schedule.wants_snapshot(6));
}

TEST(RedrawSchedule, AWindowThatIsShownAgainIsDrawn) {
  Schedule schedule = paused();
  schedule.set_visible(false);
  EXPECT_EQ(frames_between(schedule, 1, 2), 0);
  schedule.set_visible(true);
  EXPECT_EQ(frames_between(schedule, 3, 9), Schedule::kFramesPerEvent);
  schedule.set_visible(true);
  EXPECT_EQ(frames_between(schedule, 10, 19), 0) << "nothing changed";
}

TEST(RedrawSchedule, ASnapshotThatCameWhileHiddenIsDrawnAfterwards) {
  Schedule schedule = paused();
  schedule.set_visible(false);
  schedule.snapshot_arrived(1);
  EXPECT_EQ(frames_between(schedule, 1, 2), 0);
  schedule.set_visible(true);
  EXPECT_TRUE(schedule.frame_due(2));
  EXPECT_TRUE(schedule.fresh());
}

TEST(RedrawSchedule, AFastGlAlwaysDrawsAllSamples) {
  Schedule schedule(false);
  schedule.snapshot_requested();
  schedule.snapshot_arrived(0);
  schedule.begin_frame(0);
  schedule.view_moved(0);
  EXPECT_EQ(schedule.samples(2), 2);
  schedule.end_frame();
}

TEST(RedrawSchedule, ASlowGlDrawsOneSampleAndAllAfterRest) {
  Schedule schedule(kSlow);
  show_snapshot(schedule, 0);
  schedule.snapshot_requested();
  EXPECT_EQ(schedule.samples(2), 1);
  EXPECT_NEAR(schedule.sleep(0.05), Schedule::kRest - 0.05, 1e-9);
  EXPECT_FALSE(schedule.frame_due(0.9 * Schedule::kRest));
  const double rested = 1.01 * Schedule::kRest;
  EXPECT_TRUE(schedule.frame_due(rested));
  draw(schedule, rested);
  EXPECT_EQ(schedule.samples(2), 2);
  EXPECT_EQ(frames_between(schedule, rested, 9), 0) << "one sharp frame is enough";
}

TEST(RedrawSchedule, ASnapshotStartsTheRestAnew) {
  Schedule schedule(kSlow);
  for (int i = 0; i < 5; ++i) {  // each comes before the rest after the last one is over
    show_snapshot(schedule, 0.9 * i * Schedule::kRest);
    EXPECT_EQ(schedule.samples(2), 1);
  }
}

TEST(RedrawSchedule, AMovedViewStartsTheRestAnew) {
  Schedule schedule = paused(kSlow);
  frames_between(schedule, 0, 1);
  ASSERT_EQ(schedule.samples(2), 2);
  schedule.begin_frame(1);
  schedule.view_moved(1);
  EXPECT_EQ(schedule.samples(2), 1) << "in the same frame";
  schedule.end_frame();
  EXPECT_EQ(frames_between(schedule, 1, 1 + 0.9 * Schedule::kRest), 0);
  EXPECT_EQ(frames_between(schedule, 1 + 0.9 * Schedule::kRest, 9), 1);
  EXPECT_EQ(schedule.samples(2), 2);
}

TEST(RedrawSchedule, FramesOfThePanelsNeitherSharpenNorBlur) {
  Schedule schedule = paused(kSlow);
  schedule.event();
  EXPECT_EQ(frames_between(schedule, 0, 0.9 * Schedule::kRest), Schedule::kFramesPerEvent);
  EXPECT_EQ(schedule.samples(2), 1);
  frames_between(schedule, 0.9 * Schedule::kRest, 1);
  schedule.event();
  frames_between(schedule, 1, 2);
  EXPECT_EQ(schedule.samples(2), 2);
}

TEST(RedrawSchedule, AMessageEndsInAFrameOfItsOwn) {
  Schedule schedule = paused();
  EXPECT_FALSE(schedule.shows_message());
  schedule.message_shown(10);
  const double end = 10 + Schedule::kMessageSeconds;
  EXPECT_EQ(frames_between(schedule, 10, end - kTick), 0);
  EXPECT_TRUE(schedule.shows_message());
  EXPECT_NEAR(schedule.sleep(end - 0.1), 0.1, 1e-9);
  EXPECT_EQ(frames_between(schedule, end, end + 9), 1);
  EXPECT_FALSE(schedule.shows_message());
}

TEST(RedrawSchedule, ANewMessageHasItsFullTime) {
  Schedule schedule = paused();
  schedule.message_shown(10);
  schedule.message_shown(12);
  draw(schedule, 11.9 + Schedule::kMessageSeconds);
  EXPECT_TRUE(schedule.shows_message());
  draw(schedule, 12 + Schedule::kMessageSeconds);
  EXPECT_FALSE(schedule.shows_message());
}

TEST(RedrawSchedule, PanelsThatChangeByThemselvesAreDrawnAtTheEarliestOfTheirTimes) {
  Schedule schedule = paused();
  schedule.begin_frame(1);
  schedule.wake_at(1.5);
  schedule.wake_at(2);
  schedule.end_frame();
  EXPECT_NEAR(schedule.sleep(1.4), 0.1, 1e-9);
  EXPECT_FALSE(schedule.frame_due(1.4));
  EXPECT_EQ(frames_between(schedule, 1.5, 9), 1) << "that frame asks for no other";
}

TEST(RedrawSchedule, ACursorBlinksUntilAFrameShowsNone) {
  Schedule schedule = paused();
  schedule.begin_frame(1);
  schedule.cursor_shown(1);
  schedule.end_frame();
  EXPECT_NEAR(schedule.sleep(1.1), Schedule::kCursorBlink - 0.1, 1e-9);
  EXPECT_FALSE(schedule.frame_due(1 + 0.9 * Schedule::kCursorBlink));
  EXPECT_EQ(frames_between(schedule, 1, 9), 1) << "that frame shows none";
}

TEST(RedrawSchedule, AWakeUpBeforeADeadlineIsNotTheDeadline) {
  Schedule schedule = paused(kSlow);
  const double early = Schedule::kRest - 1e-9;
  EXPECT_FALSE(schedule.frame_due(early));
  EXPECT_GT(schedule.sleep(early), 0);
}

TEST(RedrawSchedule, FramesPerSecondCountDrawnSnapshots) {
  Schedule schedule(false);
  EXPECT_EQ(schedule.frames_per_second(), 0);
  show_snapshot(schedule, 7);
  EXPECT_EQ(schedule.frames_per_second(), 0) << "one frame has no rate";
  for (int i = 1; i < 20; ++i) {
    show_snapshot(schedule, 7 + 0.05 * i);
    draw(schedule, 7 + 0.05 * i + 0.01);  // a frame of the panels
    EXPECT_NEAR(schedule.frames_per_second(), 20, 1e-6);
  }
}

TEST(RedrawSchedule, FramesPerSecondFollowAChangeGradually) {
  Schedule schedule(false);
  double now = 0;
  const auto play = [&](int frames, double seconds) {
    for (int i = 0; i < frames; ++i) show_snapshot(schedule, now += seconds);
  };
  play(20, 0.1);
  play(1, 0.02);
  EXPECT_NEAR(schedule.frames_per_second(), 1 / (0.9 * 0.1 + 0.1 * 0.02), 1e-6);
  play(100, 0.02);
  EXPECT_NEAR(schedule.frames_per_second(), 50, 1);
}

TEST(RedrawSchedule, APauseDoesNotCountForFramesPerSecond) {
  Schedule schedule(false);
  show_snapshot(schedule, 0);
  show_snapshot(schedule, 0.1);
  show_snapshot(schedule, 60);
  show_snapshot(schedule, 60.1);
  EXPECT_NEAR(schedule.frames_per_second(), 10, 1e-6);
}

TEST(RedrawSchedule, AVerySlowMachineHasARateToo) {
  Schedule schedule(false);
  for (int i = 0; i < 5; ++i) show_snapshot(schedule, 2.0 * i);
  EXPECT_NEAR(schedule.frames_per_second(), 0.5, 1e-9);
}

}  // namespace
}  // namespace pupflow::window
