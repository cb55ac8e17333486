#include "app/window/repaint.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace pupflow::window {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr int kTile = Repaint::kTile;
constexpr int kWidth = 5 * kTile - 7, kHeight = 4 * kTile + 3;

struct Rectangle {
  float x, y, width, height;
  ImU32 color = IM_COL32_WHITE;
};

/// Dear ImGui without a window.
class RepaintTest : public ::testing::Test {
 protected:
  RepaintTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kWidth, kHeight};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImGui::GetStyle().AntiAliasedFill = false;
  }
  ~RepaintTest() override { ImGui::DestroyContext(); }

  ImDrawData& frame(const std::vector<Rectangle>& rectangles) {
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    for (const Rectangle& r : rectangles) {
      list.AddRectFilled({r.x, r.y}, {r.x + r.width, r.y + r.height}, r.color);
    }
    ImGui::Render();
    return *ImGui::GetDrawData();
  }

  Repaint repaint_;
};

using Canvas = std::vector<ImU32>;  // kWidth x kHeight

/// Paints what `data` holds, pixel by pixel, where a triangle covers its middle.
void paint(const ImDrawData& data, Canvas& canvas) {
  for (int l = 0; l < data.CmdListsCount; ++l) {
    const ImDrawList& list = *data.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (unsigned i = 0; i < command.ElemCount; i += 3) {
        const auto corner = [&](unsigned c) -> const ImDrawVert& {
          return list.VtxBuffer[static_cast<int>(
              command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + i + c)])];
        };
        for (int y = 0; y < kHeight; ++y) {
          for (int x = 0; x < kWidth; ++x) {
            const ImVec2 at{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            const ImVec4& clip = command.ClipRect;
            if (at.x < clip.x || at.x >= clip.z || at.y < clip.y || at.y >= clip.w) continue;
            const auto side = [&](unsigned a, unsigned b) {
              const ImVec2 p = corner(a).pos, q = corner(b).pos;
              return (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x) >= 0;
            };
            if (side(0, 1) == side(1, 2) && side(1, 2) == side(2, 0)) {
              canvas[static_cast<std::size_t>(y * kWidth + x)] = corner(0).col;
            }
          }
        }
      }
    }
  }
}

int area(const std::vector<PixelBox>& boxes) {
  int sum = 0;
  for (const PixelBox& box : boxes) sum += box.width() * box.height();
  return sum;
}

TEST_F(RepaintTest, TheFirstFrameChangesTheWholeWindowAndTheSameAgainNothing) {
  const std::vector<Rectangle> shown{{3, 4, 50, 60}};
  EXPECT_THAT(repaint_.changed(frame(shown), {}, false),
              ElementsAre(PixelBox{0, 0, kWidth, kHeight}));
  EXPECT_THAT(repaint_.changed(frame(shown), {}, false), IsEmpty());
  repaint_.forget();
  EXPECT_EQ(area(repaint_.changed(frame(shown), {}, false)), kWidth * kHeight);
}

TEST_F(RepaintTest, WhatMovesChangesWhereItWasAndWhereItIs) {
  repaint_.changed(frame({{4, 4, 8, 8}}), {}, false);
  EXPECT_THAT(repaint_.changed(frame({{kTile + 4, 4, 8, 8}}), {}, false),
              ElementsAre(PixelBox{0, 0, 2 * kTile, kTile}));
  EXPECT_THAT(repaint_.changed(frame({}), {}, false),
              ElementsAre(PixelBox{kTile, 0, 2 * kTile, kTile}));
}

TEST_F(RepaintTest, AnotherColorIsAChange) {
  repaint_.changed(frame({{4, 4, 8, 8, IM_COL32(1, 2, 3, 255)}}), {}, false);
  EXPECT_EQ(area(repaint_.changed(frame({{4, 4, 8, 8, IM_COL32(1, 2, 4, 255)}}), {}, false)),
            kTile * kTile);
}

TEST_F(RepaintTest, TheOrderInWhichThingsLieOnEachOtherCounts) {
  const Rectangle a{4, 4, 8, 8, IM_COL32(1, 2, 3, 255)}, b{6, 6, 8, 8, IM_COL32(9, 9, 9, 255)};
  repaint_.changed(frame({a, b}), {}, false);
  EXPECT_EQ(area(repaint_.changed(frame({b, a}), {}, false)), kTile * kTile);
}

TEST_F(RepaintTest, ANewImageChangesItsPlaceInBoxesThatAreAllImageOrNone) {
  const PixelBox image{10, 10, 3 * kTile, 3 * kTile};
  repaint_.changed(frame({}), {&image, 1}, true);
  EXPECT_THAT(repaint_.changed(frame({}), {&image, 1}, false), IsEmpty());
  const std::vector<PixelBox> boxes = repaint_.changed(frame({}), {&image, 1}, true);
  EXPECT_EQ(area(boxes), 9 * kTile * kTile);
  EXPECT_THAT(boxes, ::testing::Contains(PixelBox{kTile, kTile, 3 * kTile, 3 * kTile}));
  const PixelBox elsewhere{12, 10, 3 * kTile, 3 * kTile};
  EXPECT_EQ(area(repaint_.changed(frame({}), {&elsewhere, 1}, false)), kWidth * kHeight);
}

// Seeded.
TEST_F(RepaintTest, PaintingOnlyTheChangesGivesTheWholeFrames) {
  std::mt19937 random(7);
  const auto below = [&](int end) {
    return static_cast<float>(random() % static_cast<unsigned>(end));
  };
  std::vector<Rectangle> shown;
  Canvas canvas(kWidth * kHeight, 0);
  std::int64_t painted = 0;
  constexpr int kFrames = 60;
  for (int i = 0; i < kFrames; ++i) {
    if (shown.size() > 6) shown.erase(shown.begin() + static_cast<std::ptrdiff_t>(random() % 6));
    shown.push_back({below(kWidth), below(kHeight), 1 + below(40), 1 + below(40),
                     static_cast<ImU32>(random()) | IM_COL32_A_MASK});
    Canvas whole(canvas.size(), 0);
    paint(frame(shown), whole);
    ImDrawData& data = frame(shown);
    const std::vector<PixelBox> boxes = repaint_.changed(data, {}, false);
    painted += area(boxes);
    for (const PixelBox& box : boxes) {
      for (int y = box.top; y < box.bottom; ++y) {
        std::fill_n(canvas.begin() + y * kWidth + box.left, box.width(), 0u);
      }
    }
    cut_to(data, boxes);
    paint(data, canvas);
    ASSERT_EQ(canvas, whole) << "frame " << i;
  }
  EXPECT_LT(painted, kFrames * kWidth * kHeight * 2 / 3) << "mostly less than everything";
}

TEST(Gathered, CoversTheBoxesWithFew) {
  const std::vector<PixelBox> boxes{{0, 0, 10, 10}, {10, 0, 20, 10}, {100, 100, 110, 110}};
  EXPECT_THAT(gathered(boxes, 3), ::testing::ElementsAreArray(boxes));
  EXPECT_THAT(gathered(boxes, 2),
              ElementsAre(PixelBox{0, 0, 20, 10}, PixelBox{100, 100, 110, 110}));
  EXPECT_THAT(gathered(boxes, 1), ElementsAre(PixelBox{0, 0, 110, 110}));
  EXPECT_THAT(gathered({}, 1), IsEmpty());
}

}  // namespace
}  // namespace pupflow::window
