#include "app/view/flat.h"

#include <gmock/gmock.h>

namespace pupflow::view {
namespace {

constexpr Ink kBlack{{0, 0, 0}};

/// Looks down on an arena of radius 2.
Projection from_above(int side, std::span<const Ball> bodies = {}) {
  Camera camera = Camera::parse("top");
  camera.frame(2, 0.6, 1);
  return {camera, {{-2, -2, 0}, {2, 2, 1}}, side, side, bodies};
}

std::vector<Flat> flat(const Mark& mark, const Projection& projection, double scale = 1) {
  Marks marks;
  marks.marks.push_back(mark);
  std::vector<Flat> flats;
  flatten(marks, projection, scale, flats);
  return flats;
}

TEST(Flat, ALineGoesFromOnePlaceToTheOther) {
  const Projection projection = from_above(400);
  const auto flats = flat(Segment{{-1, 0, 0}, {1, 0.5, 0}, 10, kBlack}, projection, 0.5);
  ASSERT_EQ(flats.size(), 1u);
  const auto& line = std::get<FlatLine>(flats[0]);
  Eigen::Vector2d from, to;
  ASSERT_TRUE(projection.place({-1, 0, 0}, from) && projection.place({1, 0.5, 0}, to));
  EXPECT_TRUE(line.from.isApprox(from));
  EXPECT_TRUE(line.to.isApprox(to));
  EXPECT_EQ(line.width, 5);
}

TEST(Flat, APathFadesTowardsItsBeginning) {
  const Polyline path{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 3, {{0, 0, 0}, 0.8}, true};
  const auto flats = flat(path, from_above(400));
  ASSERT_EQ(flats.size(), 3u);
  for (std::size_t i = 0; i < flats.size(); ++i) {
    EXPECT_DOUBLE_EQ(std::get<FlatLine>(flats[i]).ink.opacity,
                     0.8 * static_cast<double>(i + 1) / 4);
  }
}

TEST(Flat, AnArrowHasItsTipWhereItPoints) {
  const Projection projection = from_above(400);
  const auto flats = flat(Arrow{{0, 0, 0}, {1, 0, 0}, 4, kBlack}, projection);
  ASSERT_EQ(flats.size(), 2u);
  Eigen::Vector2d tip;
  ASSERT_TRUE(projection.place({1, 0, 0}, tip));
  EXPECT_TRUE(std::get<FlatFill>(flats[1]).corners.front().isApprox(tip));
  EXPECT_LT(std::get<FlatLine>(flats[0]).to.x(), tip.x()) << "the line ends within the head";
}

TEST(Flat, ALabelIsNeverTooSmallToRead) {
  const Label label{{0, 0, 0}, {{"7"}}, 17, kBlack};
  EXPECT_EQ(std::get<FlatText>(flat(label, from_above(400), 2)[0]).size, 34);
  EXPECT_EQ(std::get<FlatText>(flat(label, from_above(400), 0.1)[0]).size, 8);
}

TEST(Flat, AnOutlineIsLeftOutBehindBodies) {
  const Polygon square{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, 2, kBlack, kBlack};
  const std::vector<Ball> body{{{1, 0, 0.3f}, 0.4f}};
  EXPECT_GT(flat(square, from_above(400)).size(), flat(square, from_above(400, body)).size());
}

TEST(Flat, ALegendHasALineForEachEntryBelowTheOther) {
  const std::vector<LegendEntry> legend{{LegendEntry::Sign::line, kBlack, {{"one"}}},
                                        {LegendEntry::Sign::area, kBlack, {{"two"}}}};
  std::vector<Flat> flats;
  flatten_legend(legend, 10, 20, 16, flats);
  std::vector<const FlatText*> words;
  for (const Flat& each : flats) {
    if (const auto* text = std::get_if<FlatText>(&each)) words.push_back(text);
  }
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(words[0]->at.x(), words[1]->at.x());
  EXPECT_GT(words[1]->at.y(), words[0]->at.y() + 16);
  const auto width_of = [](const TextLine& line, double size) {
    return size * static_cast<double>(line.front().text.size());
  };
  EXPECT_GT(legend_width(width_of, legend, 16), words[0]->at.x() - 10 + 3 * 16 - 1e-9);
}

}  // namespace
}  // namespace pupflow::view
