#include "app/view/color_scale.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "app/io/failure.h"

namespace pupflow::view {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;

const double kNan = std::numeric_limits<double>::quiet_NaN();

ColorScale scale_of(const char* field) {
  return ColorScale(*find_field(field));
}

TEST(ColorScale, SpreadsTheMapOverTheScale) {
  const ColorScale scale("inferno", -1, 3);
  EXPECT_EQ(scale(-1), scale.map[0]);
  EXPECT_EQ(scale(1), scale.map[128]);
  EXPECT_EQ(scale(2.9999), scale.map[255]);
  EXPECT_EQ(scale(3), scale.map[255]);
}

TEST(ColorScale, OutsideTakesTheNearerEnd) {
  const ColorScale scale("viridis", 0, 1);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(scale(-5), scale.map.front());
  EXPECT_EQ(scale(-infinity), scale.map.front());
  EXPECT_EQ(scale(7), scale.map.back());
  EXPECT_EQ(scale(infinity), scale.map.back());
  EXPECT_EQ(scale(std::nan("")), kUnknownColor);
}

TEST(ColorScale, NeedsAnInterval) {
  EXPECT_THROW(ColorScale("viridis", 1, 1), io::Failure);
  EXPECT_THROW(ColorScale("viridis", 1, 0), io::Failure);
  EXPECT_THROW(ColorScale("viridis", 0, std::nan("")), io::Failure);
  EXPECT_THROW(ColorScale("viridis", 0, std::numeric_limits<double>::infinity()), io::Failure);
}

TEST(ColorScale, TakesMapAndRangeOfItsField) {
  const ColorScale tb;
  EXPECT_EQ(tb.field->name, "tb");
  EXPECT_EQ(tb.map_name, "viridis");
  EXPECT_EQ(tb.min, 0);
  EXPECT_EQ(tb.max, 1);
  EXPECT_EQ(scale_of("normal_x").map_name, "bluered");
  EXPECT_EQ(scale_of("heading").map_name, "phase");
  EXPECT_EQ(scale_of("heading").max, std::numbers::pi);
  EXPECT_TRUE(scale_of("group").categorical());
}

TEST(ColorScale, TakesOpenEndsFromTheDataRoundedOutwards) {
  const std::vector<double> values{0.013, 0.31, kNan, 0.1};
  const ColorScale scale = scale_of("deformation").fitted(values);
  EXPECT_EQ(scale.min, 0);
  EXPECT_NEAR(scale.max, 0.4, 1e-12);
  EXPECT_TRUE(scale.unknown);
  EXPECT_EQ(scale.fitted(std::vector{7.0}).max, scale.max) << "fitted once, it stays";

  ColorScale typed = scale_of("deformation");
  typed.set_range(0.1, 0.2);
  EXPECT_EQ(typed.fitted(values).min, 0.1);
  EXPECT_EQ(typed.fitted(values).max, 0.2);
}

TEST(ColorScale, IsFittedToOneValueAndToNone) {
  const ColorScale same = scale_of("group_size").fitted(std::vector{1.0, 1.0});
  EXPECT_EQ(same.min, 1);
  EXPECT_EQ(same.max, 2);
  const ColorScale none = scale_of("speed").fitted(std::vector{kNan});
  EXPECT_EQ(none.min, 0);
  EXPECT_EQ(none.max, 1);
  EXPECT_TRUE(none.is_fitted());
}

TEST(ColorScale, SignedFieldsHaveTheMiddleOfTheMapAtTheirCentre) {
  ColorScale scale = scale_of("turn");
  EXPECT_EQ(scale(0), scale.map[128]);
  scale.set_range(-1, 0.5);
  EXPECT_EQ(scale(0), scale.map[128]);
  EXPECT_EQ(scale(-1), scale.map.front());
  EXPECT_EQ(scale(0.5), scale.map[192]);
}

TEST(ColorScale, AnglesMeetAtPi) {
  const ColorScale scale = scale_of("heading");
  EXPECT_EQ(scale(-std::numbers::pi), scale.map.front());
  EXPECT_EQ(scale(std::numbers::pi), scale.map.back());
}

TEST(ColorScale, CategoriesHaveColorsOfTheirOwn) {
  const ColorScale scale = scale_of("touched").fitted(std::vector{-1.0, 3.0, 0.0});
  EXPECT_EQ(scale.min, -1);
  EXPECT_EQ(scale.max, 3);
  EXPECT_EQ(scale(-1), kNobodyColor);
  EXPECT_EQ(scale(kNan), kUnknownColor);
  EXPECT_EQ(scale(3), category_colors()[3]);
  EXPECT_EQ(scale(kCategoryColors), category_colors()[0]);
}

TEST(ColorScale, RefusesWhatItsKindDoesNotHave) {
  const auto message = [](const char* field, auto change) {
    ColorScale scale = scale_of(field);
    try {
      change(scale);
    } catch (const io::Failure& failure) {
      EXPECT_EQ(failure.code(), io::ExitCode::bad_input);
      return std::string(failure.what());
    }
    return std::string("taken");
  };
  const auto range = [](ColorScale& scale) { scale.set_range(0, 1); };
  EXPECT_THAT(message("group", range), HasSubstr("categorical"));
  EXPECT_THAT(message("heading", range), HasSubstr("angle"));
  EXPECT_EQ(message("turn", range), "taken");
  const auto automatic = [](ColorScale& scale) { scale.set_ends(Ends::automatic); };
  EXPECT_THAT(message("group", automatic), HasSubstr("categorical"));
  EXPECT_THAT(message("heading", automatic), HasSubstr("angle"));
  EXPECT_THAT(message("turn", [](ColorScale& scale) { scale.set_ends(Ends::around_tp); }),
              HasSubstr("no temperature"));
  EXPECT_THAT(message("side", [](ColorScale& scale) { scale.set_map("jet"); }),
              HasSubstr("categorical"));
  EXPECT_THAT(message("tb", [](ColorScale& scale) { scale.set_map("rainbow"); }),
              HasSubstr("rainbow"));
}

std::vector<double> hundred(double first, double last) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(first + i * (last - first) / 100);
  return values;
}

TEST(ColorScale, AutomaticEndsHoldTheMiddleOfTheValues) {
  ColorScale scale;
  scale.set_ends(Ends::automatic);
  EXPECT_FALSE(scale.is_fitted());
  const ColorScale fitted = scale.fitted(hundred(0.2, 0.4));
  EXPECT_NEAR(fitted.min, 0.21, 1e-12);
  EXPECT_NEAR(fitted.max, 0.39, 1e-12);
  EXPECT_TRUE(fitted.below);
  EXPECT_TRUE(fitted.above);
  EXPECT_EQ(scale.fitted(std::vector{kNan}).max, 1);
}

TEST(ColorScale, AutomaticEndsDoNotSpreadWhatIsAlmostEqual) {
  ColorScale scale;
  scale.set_ends(Ends::automatic);
  const ColorScale fitted = scale.fitted(std::vector{0.86, 0.861});
  EXPECT_NEAR(fitted.max - fitted.min, 0.02, 1e-12);
  EXPECT_NEAR((fitted.max + fitted.min) / 2, 0.8605, 1e-12);
  EXPECT_FALSE(fitted.below);
}

TEST(ColorScale, AutomaticEndsOfASignedFieldKeepItsCentre) {
  ColorScale scale = scale_of("turn");
  scale.set_ends(Ends::automatic);
  const ColorScale fitted = scale.fitted(hundred(-0.1, 0.4));
  EXPECT_NEAR(fitted.max, 0.375, 1e-12);
  EXPECT_NEAR(fitted.min, -0.375, 1e-12);
}

TEST(ColorScale, AroundTpHasThePreferredTemperatureInTheMiddle) {
  ColorScale scale;
  scale.set_ends(Ends::around_tp);
  EXPECT_EQ(scale.map_name, "bluered");
  const ColorScale fitted = scale.fitted(hundred(0.4, 0.5), 0.6);
  EXPECT_NEAR(fitted.min, 0.405, 1e-12);
  EXPECT_NEAR(fitted.max, 0.795, 1e-12);
  EXPECT_EQ(fitted(0.6), fitted.map[128]);
  ColorScale own("inferno", 0, 1);
  own.set_ends(Ends::around_tp);
  EXPECT_EQ(own.map_name, "inferno");
}

TEST(ColorScale, FollowsTheDataOnlyWhereThereIsAScaleToFit) {
  for (const char* name : {"tb", "turn", "deformation"}) {
    ColorScale scale = scale_of(name);
    scale.follow_data();
    EXPECT_EQ(scale.ends, Ends::automatic) << name;
    EXPECT_TRUE(scale.follows(scale)) << name;
  }
  for (const char* name : {"group", "heading"}) {
    ColorScale scale = scale_of(name);
    scale.follow_data();
    EXPECT_EQ(scale.ends, Ends::field) << name;
    EXPECT_FALSE(scale.follows(scale)) << name;
  }
  EXPECT_NEAR(easing(0.5), 1 - std::exp(-1), 1e-12);
  EXPECT_EQ(easing(0), 0);
}

TEST(ColorScale, EasesTowardsNewEnds) {
  const ColorScale before("viridis", 0, 1), now("viridis", 1, 3);
  const ColorScale half = now.eased(before, 0.5);
  EXPECT_EQ(half.min, 0.5);
  EXPECT_EQ(half.max, 2);
  EXPECT_TRUE(now.eased(before, 1).same_as(now));
}

TEST(Ticks, AreRoundAndWithinTheScale) {
  const auto near = [](const std::vector<double>& values) {
    return Pointwise(DoubleNear(1e-12), values);
  };
  EXPECT_THAT(round_ticks(0, 1, 5), near({0, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_THAT(round_ticks(0.25, 0.71, 5), near({0.3, 0.4, 0.5, 0.6, 0.7}));
  EXPECT_THAT(round_ticks(-1, 2, 5), near({-1, 0, 1, 2}));
  EXPECT_THAT(round_ticks(0, 2500, 5), near({0, 500, 1000, 1500, 2000, 2500}));
  EXPECT_THAT(round_ticks(1, 2, 5, 1), near({1, 2}));
}

TEST(Ticks, AreNoneWhereTheScaleIsNotFinite) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(round_ticks(0, kInf, 5), IsEmpty());
  EXPECT_THAT(round_ticks(-kInf, kInf, 5), IsEmpty());
  EXPECT_THAT(round_ticks(0, std::nan(""), 5), IsEmpty());
  EXPECT_EQ(round_ticks(0, 1.7e308, 5).size(), 4u);
  EXPECT_FALSE(std::signbit(round_ticks(-0.1, 1, 5).front()));
}

TEST(ColorScale, TakesTheLargestNumbers) {
  const std::vector<double> values{-1.7e308, 0, 1.7e308};
  for (const LitterField* field : {&pup_fields().front(), find_field("turn")}) {
    ColorScale scale(*field);
    for (const Ends ends : {Ends::field, Ends::automatic}) {
      scale.set_ends(ends);
      const ColorScale fitted = scale.fitted(values);
      EXPECT_TRUE(std::isfinite(fitted.max - fitted.min));
      EXPECT_LT(fitted.min, fitted.max);
      EXPECT_TRUE(fitted.above && fitted.below);
    }
    scale.set_range(0, 1.7e308);
    EXPECT_NE(scale(0.1e308), scale(1.6e308));
  }
}

TEST(ColorScale, TheFieldsOwnRangeIsItsHoweverItWasNamed) {
  ColorScale scale;
  scale.set_range(0, 2);
  EXPECT_EQ(scale.ends, Ends::typed);
  scale.set_range(0, 1);
  EXPECT_EQ(scale.ends, Ends::field);
}

}  // namespace
}  // namespace pupflow::view
