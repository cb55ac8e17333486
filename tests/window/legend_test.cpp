// The legend's arithmetic: ends that are dragged and typed, what fits into its strip.
#include <gmock/gmock.h>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/view/color_bar.h"
#include "app/window/panels/color_ends.h"
#include "app/window/panels/legend_plan.h"

namespace pupflow::window {
namespace {

using ::testing::HasSubstr;

constexpr EndDrag kHigh{ScaleEnd::high, 0.4, 0.8, 200, 100},
    kLow{ScaleEnd::low, 0.4, 0.8, 200, 300};

TEST(EndDrag, GoesAsFarUpTheScaleAsTheMouseGoesUp) {
  EXPECT_DOUBLE_EQ(kHigh.value_at(100), 0.8);
  EXPECT_DOUBLE_EQ(kHigh.value_at(50), 0.9);
  EXPECT_DOUBLE_EQ(kHigh.value_at(150), 0.7);
  EXPECT_DOUBLE_EQ(kLow.value_at(350), 0.3);
  EXPECT_DOUBLE_EQ(kLow.value_at(250), 0.5);
}

TEST(EndDrag, GivesNumbersAsRoundAsAPixelAllows) {
  const EndDrag drag{ScaleEnd::high, 0, 0.7391827, 300, 0};
  EXPECT_EQ(drag.value_at(-1), 0.742);
  const EndDrag wide{ScaleEnd::high, 0, 30000, 300, 0};
  EXPECT_EQ(wide.value_at(-7), 30700);
}

TEST(EndDrag, StaysOnItsSideOfTheOtherEnd) {
  EXPECT_GT(kHigh.value_at(1000), 0.4);
  EXPECT_LT(kLow.value_at(-1000), 0.8);
}

TEST(ColorEnds, OneIsTypedAndTheOtherStaysWhereItIsSeen) {
  view::ColorScale scale;
  scale.follow_data();
  view::ColorScale fitted = scale;
  fitted.min = 0.41237;
  fitted.max = 0.61;
  const view::ColorScale typed = with_end(scale, fitted, ScaleEnd::high, 0.75);
  EXPECT_EQ(typed.max, 0.75);
  EXPECT_EQ(io::number_text(typed.min), end_text(fitted.min, fitted.min, fitted.max));
  EXPECT_EQ(typed.ends, view::Ends::typed);
}

TEST(ColorEnds, AnEndBeyondTheOtherIsRefusedWithItsValue) {
  view::ColorScale scale;
  scale.set_range(0.25, 0.5);
  for (const auto& [end, value, words] : {std::tuple(ScaleEnd::high, 0.25, "must be above 0.25"),
                                          std::tuple(ScaleEnd::low, 0.6, "must be below 0.5")}) {
    try {
      with_end(scale, scale, end, value);
      ADD_FAILURE() << value;
    } catch (const io::Failure& failure) {
      EXPECT_THAT(failure.what(), HasSubstr(words));
    }
  }
}

TEST(ColorEnds, AroundTpTakesItsColorMapAwayAgain) {
  view::ColorScale scale;
  choose_ends(scale, view::Ends::around_tp);
  EXPECT_EQ(scale.map_name, "bluered");
  choose_ends(scale, view::Ends::field);
  EXPECT_EQ(scale.map_name, "viridis");
  EXPECT_EQ(scale.max, 1);
  scale.set_map("inferno");
  choose_ends(scale, view::Ends::around_tp);
  choose_ends(scale, view::Ends::automatic);
  EXPECT_EQ(scale.map_name, "inferno") << "chosen by hand";
}

TEST(ColorEnds, EachFieldHasTheChoicesThatMakeSense) {
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      view::ColorScale scale(field);
      for (const view::Ends ends :
           {view::Ends::automatic, view::Ends::field, view::Ends::around_tp}) {
        EXPECT_FALSE(ends_label(scale, ends).empty());
        if (ends_apply(scale, ends)) {
          EXPECT_NO_THROW(choose_ends(scale, ends)) << field.name;
        } else {
          EXPECT_THROW(scale.set_ends(ends), io::Failure) << field.name;
        }
      }
    }
  }
}

LegendStrip strip_of(float height, float scale, const view::ColorScale& scale_of) {
  const bool ends = ends_apply(scale_of, view::Ends::automatic);
  return {.height = height,
          .em = 14 * scale,
          .row = 25 * scale,
          .maps = (ends ? 1 : 0) + (scale_of.categorical() ? 0 : 1),
          .has_ends = ends,
          .section = 10,
          .least_bar = least_bar(scale_of),
          .usual = usual_bar(scale_of)};
}

TEST(LegendPlan, FitsEveryStrip) {
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      const view::ColorScale scale(field);
      for (const float of : {1.0f, 1.5f, 2.0f}) {
        int before = -1;
        for (float height = kLeastLegendHeight; height < 1500; height += 10) {
          const LegendStrip strip = strip_of(height, of, scale);
          const LegendPlan plan = plan_legend(strip);
          const int rows = plan.field + plan.button + 2 * plan.ends +
                           (plan.lists ? strip.maps : 0) + (plan.section ? strip.section : 0);
          EXPECT_LE(static_cast<float>(rows) * strip.row + plan.bar, height + 1e-3f) << field.name;
          EXPECT_GT(plan.bar, 0);
          EXPECT_FALSE(plan.button && plan.section);
          EXPECT_GE(rows, before) << "nothing goes away in a higher strip: " << field.name;
          before = rows;
        }
      }
    }
  }
}

TEST(LegendPlan, ATallStripHasItAll) {
  const LegendPlan plan = plan_legend(strip_of(780, 1, view::ColorScale()));
  EXPECT_TRUE(plan.field && plan.ends && plan.lists && plan.section);
  EXPECT_FALSE(plan.button);
  EXPECT_GE(plan.bar, 200);
}

TEST(LegendBar, WithoutItsTitleItIsNarrowerAndSaysTheSame) {
  const view::ColorScale scale;
  view::ColorBarStyle style;
  const int titled = view::color_bar_margins(scale, style).right;
  const view::Box bar{40, 10, 16, 200};
  const std::size_t labels =
      view::lay_out_color_bar(bar, {30, 60}, scale, 0.6, style).labels.size();
  style.titled = false;
  EXPECT_LT(view::color_bar_margins(scale, style).right, titled);
  EXPECT_EQ(view::lay_out_color_bar(bar, {30, 60}, scale, 0.6, style).labels.size(), labels - 1);
}

}  // namespace
}  // namespace pupflow::window
