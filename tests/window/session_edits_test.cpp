// Ramps, undo and redo.
#include <gmock/gmock.h>

#include "tests/window/session_words.h"

namespace pupflow::window {
namespace {

using testing::HasSubstr;

TEST(Timeline, ARampThereAndBack) {
  Session session(small_litter(), true);
  play(session, 10);
  have(session, RampTo{place("ta"), 0.8, 40, true});
  const LiveState begun = look_at(session);
  ASSERT_EQ(begun.timeline.marks.size(), 1u);
  EXPECT_EQ(begun.timeline.marks[0].step, 10);
  EXPECT_EQ(begun.timeline.marks[0].until, 90);
  EXPECT_EQ(begun.timeline.marks[0].text, "T_a 0.4 \u2192 0.8 and back");
  play(session, 41);
  EXPECT_DOUBLE_EQ(value(session, "ta"), 0.8);
  play(session, 40);
  EXPECT_DOUBLE_EQ(value(session, "ta"), 0.4);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
}

TEST(Timeline, SaysWhyARampCannotBe) {
  Session session(small_litter(), true);
  const auto rejected = [&](const RampTo& ramp) {
    have(session, ramp);
    return look_at(session).rejected;
  };
  EXPECT_THAT(rejected({place("pups"), 20, 10}), HasSubstr("pups cannot"));
  EXPECT_THAT(rejected({place("contact"), 1, 10}), HasSubstr("contact has no values between"));
  EXPECT_THAT(rejected({place("alpha"), 2, 10}), HasSubstr("alpha"));
  EXPECT_THAT(rejected({place("ta"), std::nan(""), 10}), HasSubstr("ta"));
  EXPECT_THAT(rejected({place("ta"), 0.2, 0}), HasSubstr("step"));
  EXPECT_THAT(rejected({9999, 0.2, 10}), HasSubstr("no such"));
  EXPECT_TRUE(look_at(session).view().recipe.schedule.empty());
  EXPECT_EQ(rejected({place("ta"), 0.2, 10}), "");
}

TEST(Timeline, UndoTakesBackEditsAndRedoMakesThemAgain) {
  Session session(small_litter(), true);
  play(session, 5);
  set(session, "ta", 0.1);
  play(session, 5);
  set(session, "gravity", 2);
  play(session, 5);
  have(session, Undo{});
  EXPECT_EQ(value(session, "gravity"), 10);
  play(session, 5);
  have(session, Undo{});
  EXPECT_EQ(value(session, "ta"), 0.4);
  EXPECT_FALSE(look_at(session).timeline.can_undo);
  have(session, Undo{});
  have(session, Redo{});
  have(session, Redo{});
  EXPECT_FALSE(look_at(session).timeline.can_redo);
  EXPECT_EQ(value(session, "ta"), 0.1);
  EXPECT_EQ(value(session, "gravity"), 2);
  play(session, 5);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  set(session, "ta", 0.3);
  have(session, Undo{});
  set(session, "ta", 0.2);
  EXPECT_FALSE(look_at(session).timeline.can_redo) << "what was undone is gone";
}

TEST(Timeline, AnEditThatIsUndoneAtOnceLeavesNoTrace) {
  Session session(small_litter(), true);
  play(session, 5);
  const LiveState before = look_at(session);
  set(session, "ta", 0.1);
  have(session, RampTo{place("ta"), 0.9, 30});
  have(session, Undo{});
  have(session, Undo{});
  EXPECT_EQ(look_at(session).view().recipe, before.view().recipe);
  EXPECT_EQ(look_at(session).view().params, before.view().params);
  EXPECT_TRUE(look_at(session).timeline.marks.empty());
}

TEST(Timeline, UndoneARampEnds) {
  Session session(small_litter(), true);
  play(session, 10);
  have(session, RampTo{place("ta"), 0.8, 40, true});
  play(session, 20);
  EXPECT_GT(value(session, "ta"), 0.5);
  have(session, Undo{});
  EXPECT_EQ(value(session, "ta"), 0.4);
  EXPECT_EQ(look_at(session).timeline.marks[0].until, 30);
  play(session, 100);
  EXPECT_EQ(value(session, "ta"), 0.4);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  have(session, Redo{});
  play(session, 41);
  EXPECT_DOUBLE_EQ(value(session, "ta"), 0.8);
}

TEST(Timeline, AnEditEndsARampOfTheSameParameter) {
  Session session(small_litter(), true);
  have(session, RampTo{place("ta"), 0.8, 40, true});
  play(session, 20);
  set(session, "ta", 0.3);
  play(session, 100);
  EXPECT_EQ(value(session, "ta"), 0.3);
}

TEST(Timeline, OneDragIsOneEntry) {
  Session session(small_litter(), true);
  set(session, "ta", 0.3);
  for (int i = 1; i <= 5; ++i) {
    set(session, "gravity", 10 - i, i > 1);
    play(session, 3);
  }
  const LiveState dragged = look_at(session);
  ASSERT_EQ(dragged.timeline.marks.size(), 2u);
  EXPECT_EQ(dragged.timeline.marks[1].text, "g 10 \u2192 5");
  have(session, Undo{});
  EXPECT_EQ(value(session, "gravity"), 10);
  EXPECT_EQ(value(session, "ta"), 0.3);
}

TEST(Timeline, UndoOfARestartRestartsBack) {
  Session session(small_litter(), true);
  play(session, 20);
  set(session, "pups", 5);
  play(session, 20);
  have(session, Undo{});
  EXPECT_EQ(look_at(session).view().pups, 3);
  EXPECT_EQ(look_at(session).view().step, 0);
  have(session, Redo{});
  EXPECT_EQ(look_at(session).view().pups, 5);
}

TEST(Timeline, UndoOfARestartGoesBackToTheCheckpoint) {
  Simulation start(small_litter());
  start.run(130);
  Session session(start.recipe(), true, 1, start.snapshot());
  play(session, 150);
  const LiveState then = look_at(session);
  have(session, GoTo{135});
  EXPECT_EQ(look_at(session).timeline.first, 130);
  set(session, "pups", 5);
  EXPECT_EQ(look_at(session).view().step, 0);
  have(session, Undo{});
  play(session, 150);
  EXPECT_EQ(look_at(session).hash, then.hash);
}

}  // namespace
}  // namespace pupflow::window
