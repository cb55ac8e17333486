// Marks over the arena, as Dear ImGui's triangles: no window, no OpenGL.
#include "app/window/arena_marks.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "pupflow/simulation.h"

namespace pupflow::window {
namespace {

constexpr view::Ink kBlack{{0, 0, 0}};
const Area kArena{{300, 40}, {600, 500}};

/// The rectangle around what a list draws.
struct Extent {
  float left = 1e9f, top = 1e9f, right = -1e9f, bottom = -1e9f;
};

class ArenaMarksTest : public ::testing::Test {
 protected:
  ArenaMarksTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1400, 900};
    io.Fonts->AddFontDefault();
    io.Fonts->Build();
    ImGui::NewFrame();
    camera_.frame(2, 0.6, static_cast<double>(kArena.size.x / kArena.size.y));
  }
  ~ArenaMarksTest() override {
    ImGui::EndFrame();
    ImGui::DestroyContext();
  }

  ImDrawList& list() { return *ImGui::GetBackgroundDrawList(); }

  Extent extent_from(int first) {
    Extent extent;
    for (int i = first; i < list().VtxBuffer.Size; ++i) {
      const ImVec2 place = list().VtxBuffer[i].pos;
      extent.left = std::min(extent.left, place.x);
      extent.right = std::max(extent.right, place.x);
      extent.top = std::min(extent.top, place.y);
      extent.bottom = std::max(extent.bottom, place.y);
    }
    return extent;
  }

  view::Camera camera_ = view::Camera::parse("top");
};

TEST_F(ArenaMarksTest, ALineLiesWhereTheCameraSeesIt) {
  view::Marks marks;
  marks.marks.emplace_back(view::Segment{{-1, 0.5, 0}, {1, 0.5, 0}, 4, kBlack});
  const int first = list().VtxBuffer.Size;
  paint_marks(list(), marks, camera_, kArena);
  const view::Projection projection = projection_on(camera_, kArena);
  Eigen::Vector2d from, to;
  ASSERT_TRUE(projection.place({-1, 0.5, 0}, from) && projection.place({1, 0.5, 0}, to));
  const Extent extent = extent_from(first);
  EXPECT_NEAR(extent.left, 300 + from.x(), 2);
  EXPECT_NEAR(extent.right, 300 + to.x(), 2);
  EXPECT_NEAR((extent.top + extent.bottom) / 2, 40 + from.y(), 2);
}

TEST_F(ArenaMarksTest, NothingIsPaintedOutsideTheArena) {
  view::Marks marks;
  marks.marks.emplace_back(view::Segment{{-50, 0, 0}, {50, 0, 0}, 4, kBlack});
  paint_marks(list(), marks, camera_, kArena);
  bool found = false;
  for (const ImDrawCmd& command : list().CmdBuffer) {
    if (command.ElemCount == 0) continue;
    found = true;
    EXPECT_GE(command.ClipRect.x, kArena.corner.x);
    EXPECT_LE(command.ClipRect.z, kArena.corner.x + kArena.size.x);
  }
  EXPECT_TRUE(found);
}

TEST_F(ArenaMarksTest, TheCentreOfTheArenaIsTheMiddleOfItsPlace) {
  view::Marks marks;
  marks.marks.emplace_back(view::Segment{{0, 0, 0}, {0, 0, 0}, 10, kBlack});
  const int first = list().VtxBuffer.Size;
  paint_marks(list(), marks, camera_, kArena);
  const Extent extent = extent_from(first);
  EXPECT_NEAR((extent.left + extent.right) / 2, kArena.middle().x, 1);
}

TEST_F(ArenaMarksTest, LabelsOfMarksAreAsLargeAsThePanelsText) {
  EXPECT_DOUBLE_EQ(mark_scale(960, 14), 1);
  EXPECT_DOUBLE_EQ(17 * mark_scale(300, 28), 28);
}

TEST_F(ArenaMarksTest, OverlaysArePaintedWhenTheyAreChosenAndTrailsGrow) {
  Params params;
  params.pups = 4;
  Simulation simulation(params);
  pictures::Look look;
  ArenaMarks marks;
  const auto painted = [&](bool fresh) {
    const int first = list().VtxBuffer.Size;
    const LitterView litter = simulation.view();
    marks.paint(list(), {litter, look.scale, camera_, {}, kArena}, fresh, look);
    return list().VtxBuffer.Size - first;
  };
  const int bare = painted(true);
  EXPECT_GT(bare, 0) << "the scale bar";
  look.overlays.set("trails", true);
  const int first = painted(true);
  EXPECT_GT(first, bare) << "the legend of the trails";
  simulation.run(20);
  EXPECT_GT(painted(true), first);
  EXPECT_EQ(marks.trails().of(0).size(), 2u);
  look.trail = 0.5;
  painted(false);
  EXPECT_EQ(marks.trails().of(0).size(), 1u) << "another length begins anew";
  look.overlays.set("trails", false);
  EXPECT_EQ(painted(false), bare);
  EXPECT_EQ(marks.trails().seconds(), 0);
}

}  // namespace
}  // namespace pupflow::window
