#include "app/window/panels/plot_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "app/window/panels/figure2_curve.h"
#include "app/window/panels/plot_curves.h"
#include "app/window/panels/plots_panel.h"

namespace pupflow::window {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TEST(PlotAxis, TakesValuesToPlacesAndBack) {
  const Axis rising{{-1, 3}, 100, 300};
  EXPECT_FLOAT_EQ(rising.place(-1), 100);
  EXPECT_FLOAT_EQ(rising.place(3), 300);
  EXPECT_FLOAT_EQ(rising.place(0), 150);
  EXPECT_DOUBLE_EQ(rising.value(150), 0);
  const Axis upwards{{0, 1}, 500, 400};  // y grows downwards in a window
  EXPECT_FLOAT_EQ(upwards.place(0.25), 475);
  EXPECT_DOUBLE_EQ(upwards.value(475), 0.25);
}

TEST(PlotAxis, AValueFarOutsideStaysANumber) {
  const Axis axis{{0, 1e-9}, 0, 100};
  EXPECT_TRUE(std::isfinite(axis.place(1e300)));
  EXPECT_TRUE(std::isfinite(axis.place(-1e300)));
}

TEST(PlotTicks, StandAtRoundNumbersWithEqualDecimals) {
  const auto found = ticks({0.38, 0.83}, 5);
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found.front().text, "0.4");
  EXPECT_EQ(found.back().text, "0.8");
  EXPECT_EQ(ticks({0, 0.1}, 4).at(1).text, "0.05");
  EXPECT_EQ(ticks({-1, 1}, 2).at(1).text, "0");
}

TEST(PlotTicks, OfWholeNumbersAreWhole) {
  for (const Tick& tick : ticks({0, 2}, 8, 1)) EXPECT_EQ(tick.value, std::round(tick.value));
  EXPECT_EQ(ticks({0, 2}, 8, 1).size(), 3u);
}

TEST(PlotTicks, DoNotTouchHoweverShortTheAxisIs) {
  const auto width = [](const std::string& text) { return 7.0f * static_cast<float>(text.size()); };
  for (const double high : {0.003, 1.0, 12.0, 36'000.0}) {
    for (float length = 5; length < 900; length += 7) {
      const Axis axis{{0, high}, 0, length};
      const auto found = ticks_that_fit(axis, 10, 4, width);
      for (std::size_t i = 1; i < found.size(); ++i) {
        const float end = axis.place(found[i - 1].value) + width(found[i - 1].text) / 2;
        ASSERT_LE(end + 4, axis.place(found[i].value) - width(found[i].text) / 2 + 0.01f)
            << length << " pixels to " << high;
      }
      EXPECT_GE(found.size(), length > 300 ? 3u : 0u) << length << " pixels to " << high;
    }
  }
}

TEST(PlotRange, IsRoundedOutwardsToTicks) {
  const Range range = rounded({0.41, 0.78}, 4);
  EXPECT_NEAR(range.low, 0.4, 1e-12);
  EXPECT_NEAR(range.high, 0.8, 1e-12);
  const Range kept = rounded({0.4, 0.8}, 4);
  EXPECT_NEAR(kept.low, 0.4, 1e-12);
  EXPECT_NEAR(kept.high, 0.8, 1e-12);
}

TEST(PlotRange, IsNeverEmpty) {
  for (const Range& range : {Range{3, 3}, Range{0, 0}, Range{1e300, 1e300}, Range{1, -1}}) {
    const Range found = rounded(range, 4);
    EXPECT_LT(found.low, found.high);
    EXPECT_FALSE(ticks(range, 4).empty());
  }
}

TEST(PlotRange, TakesInWhatIsKnown) {
  Range range{0, 1};
  widen(range, kUnknown);
  widen(range, std::numeric_limits<double>::infinity());
  widen(range, -0.5);
  widen(range, 0.7);
  EXPECT_EQ(range.low, -0.5);
  EXPECT_EQ(range.high, 1);
}

TEST(PlotColumns, KeepEveryExtremeInItsColumn) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i < 10'000; ++i) {
    const double y = std::sin(0.37 * i) * ((i * 7919) % 101);
    curve.push_back({static_cast<double>(i), y, y - 1, y + 1});
  }
  const Axis axis{{0, 9999}, 0, 50};
  const auto found = columns(curve, axis);
  ASSERT_EQ(found.size(), 51u);
  for (const Column& column : found) {
    double low = 1e9, high = -1e9;
    for (const CurvePoint& point : curve) {
      if (std::lround(axis.place(point.x)) != std::lround(column.x)) continue;
      low = std::min(low, point.low);
      high = std::max(high, point.high);
    }
    ASSERT_EQ(column.low, low);
    ASSERT_EQ(column.high, high);
  }
  EXPECT_EQ(found.front().first, curve.front().mean);
  EXPECT_EQ(found.back().last, curve.back().mean);
}

TEST(PlotColumns, LeaveOutWhatIsNotKnown) {
  const std::vector<CurvePoint> curve{{0, kUnknown, 0, 0}, {1, 2, 2, 2}, {2, kUnknown, 0, 0}};
  const auto found = columns(curve, {{0, 2}, 0, 100});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 2);
}

TEST(PlotSmoothing, IsTheMeanOfTheWindowUpToEachPoint) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i < 20; ++i) {
    const double y = i == 0 ? kUnknown : i;
    curve.push_back({0.1 * i, y, y, y});
  }
  const std::vector<int> once(curve.size(), 1);
  const auto found = smoothed(curve, once, 0.4 - 1e-9);  // four points
  ASSERT_EQ(found.size(), curve.size());
  EXPECT_TRUE(std::isnan(found[0].mean));
  EXPECT_NEAR(found[2].mean, 1.5, 1e-9);
  EXPECT_NEAR(found[10].mean, (7 + 8 + 9 + 10) / 4.0, 1e-9);
  std::vector<int> weights = once;
  weights[10] = 3;  // stands for three steps
  EXPECT_NEAR(smoothed(curve, weights, 0.4 - 1e-9)[10].mean, (7 + 8 + 9 + 30) / 6.0, 1e-9);
}

TEST(PlotHistogram, CountsEveryValueOnce) {
  const std::vector<double> values{0, 0.1, 0.24, 0.25, 0.5, 1, -3, 9, kUnknown};
  const Histogram found = histogram(values, {0, 1}, 4);
  EXPECT_EQ(found.counts, (std::vector<int>{4, 1, 1, 2}));
}

TEST(PlotReading, IsThatOfTheStepUnderTheMouse) {
  const std::vector<CurvePoint> curve{{1, 10, 0, 0}, {2, 20, 0, 0}, {3, kUnknown, 0, 0}};
  EXPECT_EQ(value_at(curve, 1.5), 20);
  EXPECT_EQ(value_at(curve, 2), 20);
  EXPECT_EQ(value_at(curve, 2.5), std::nullopt);
  EXPECT_EQ(value_at(curve, 3.5), std::nullopt);
}

TEST(PlotSpan, FollowsTheEndAndShowsTheFutureWhereThereIsOne) {
  const auto expect = [](const Range& shown, double low, double high) {
    EXPECT_DOUBLE_EQ(shown.low, low);
    EXPECT_DOUBLE_EQ(shown.high, high);
  };
  expect(shown_time(0, 3, 3, 10), 0, 10);     // fills from the left
  expect(shown_time(0, 50, 50, 10), 40, 50);  // then runs along
  expect(shown_time(0, 50, 20, 10), 15, 25);  // gone back to 20 s
  expect(shown_time(0, 50, 48, 10), 40, 50);
  expect(shown_time(0, 50, 1, 10), 0, 10);
  expect(shown_time(2, 50, 20, std::numeric_limits<double>::infinity()), 2, 50);
}

TEST(Figure2Curve, IsThatOfTheShippedData) {
  const auto curve = figure2_curve();
  ASSERT_EQ(curve.size(), 24u);
  EXPECT_EQ(curve.front().ta, 0);
  EXPECT_EQ(curve.back().ta, 1);
  EXPECT_NEAR(curve.front().huddling, 0.58, 0.02);
  EXPECT_LT(curve[13].huddling, 0.2) << "the warm side of the transition";
  for (const HuddlingPoint& point : curve) EXPECT_GT(point.deviation, 0);
}

}  // namespace
}  // namespace pupflow::window
