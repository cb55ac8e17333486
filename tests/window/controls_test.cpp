#include "app/window/controls.h"

#include <gmock/gmock.h>

#include <cmath>

namespace pupflow::window {
namespace {

TEST(Controls, ASoundProposalIsSentWhole) {
  Controls controls;
  Params edited;
  edited.ambient_temperature = 0.2;
  controls.propose(edited);
  ASSERT_EQ(controls.commands.size(), 1u);
  EXPECT_EQ(std::get<Edit>(controls.commands[0]).params, edited);
  EXPECT_EQ(controls.params, edited);
}

TEST(Controls, AnUnsoundProposalIsRefusedWithItsReason) {
  Controls controls;
  Params edited;
  edited.arena_radius = 0.2;  // fine on its own, too small for a pup
  controls.propose(edited);
  EXPECT_TRUE(controls.commands.empty());
  EXPECT_EQ(controls.params, Params{});
  EXPECT_THAT(controls.problem, testing::HasSubstr("arena_radius"));
  controls.propose(Params{});
  EXPECT_EQ(controls.problem, "");
  EXPECT_TRUE(controls.commands.empty()) << "nothing changed";
}

TEST(Controls, SpeedStaysInItsRange) {
  Controls controls;
  controls.set_speed(1e9);
  EXPECT_EQ(std::get<Speed>(controls.commands.back()).factor, Controls::kFastest);
  controls.set_speed(0);
  EXPECT_EQ(std::get<Speed>(controls.commands.back()).factor, Controls::kSlowest);
  controls.set_as_fast(true);
  EXPECT_TRUE(std::isinf(std::get<Speed>(controls.commands.back()).factor));
  controls.set_as_fast(false);
  EXPECT_EQ(std::get<Speed>(controls.commands.back()).factor, Controls::kSlowest);
}

TEST(Controls, AnotherFieldHasTheScaleOfItsKind) {
  Controls controls;
  controls.look.scale.set_map("inferno");
  controls.look.scale.set_range(0.2, 0.4);
  controls.color_by(*find_field("turn"));
  EXPECT_EQ(controls.look.scale.field->name, "turn");
  EXPECT_EQ(controls.look.scale.map_name, "bluered");
  EXPECT_EQ(controls.look.scale.ends, view::Ends::automatic);
  ASSERT_EQ(controls.commands.size(), 1u);
  const auto* command = std::get_if<ColorBy>(&controls.commands.front());
  ASSERT_NE(command, nullptr);
  EXPECT_EQ(command->field->name, "turn");
}

}  // namespace
}  // namespace pupflow::window
