#include "app/window/typed_number.h"

#include <gmock/gmock.h>

namespace pupflow::window {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

double number(const Typed& typed) {
  EXPECT_TRUE(std::holds_alternative<double>(typed));
  return std::holds_alternative<double>(typed) ? std::get<double>(typed) : -999;
}

std::string reason(const Typed& typed) {
  return std::holds_alternative<std::string>(typed) ? std::get<std::string>(typed) : "";
}

TEST(TypedNumber, ACommaIsADecimalPoint) {
  EXPECT_EQ(number(read_typed("1,5")), 1.5);
  EXPECT_EQ(number(read_typed("1.5")), 1.5);
  EXPECT_EQ(number(read_typed("-0,25e1")), -2.5);
  EXPECT_THAT(reason(read_typed("1,000,000")), HasSubstr("several commas"));
  EXPECT_THAT(reason(read_typed("1.000,5")), HasSubstr("'1.000,5' is no number"));
}

TEST(TypedNumber, BlanksAndAPlusDoNotCount) {
  EXPECT_EQ(number(read_typed("  +3 ")), 3);
}

TEST(TypedNumber, KeepsAllDigits) {
  EXPECT_EQ(number(read_typed("0.12345678901234567")), 0.12345678901234567);
}

TEST(TypedNumber, SaysWhatIsNoNumber) {
  EXPECT_THAT(reason(read_typed("abc")), HasSubstr("'abc' is no number"));
  EXPECT_THAT(reason(read_typed("12q")), HasSubstr("no number"));
  EXPECT_THAT(reason(read_typed("inf")), HasSubstr("no number"));
  EXPECT_THAT(reason(read_typed("nan")), HasSubstr("no number"));
  EXPECT_THAT(reason(read_typed("+")), HasSubstr("no number"));
  EXPECT_THAT(reason(read_typed("--1")), HasSubstr("no number"));
  EXPECT_THAT(reason(read_typed("  ")), HasSubstr("nothing"));
  EXPECT_THAT(reason(read_typed("1e400")), HasSubstr("too large"));
}

TEST(TypedNumber, AParameterHasItsOwnRange) {
  const Parameter& alpha = *find_parameter("alpha");
  EXPECT_EQ(number(read_typed(alpha, "0,25")), 0.25);
  EXPECT_THAT(reason(read_typed(alpha, "7")), AllOf(HasSubstr("alpha"), HasSubstr("0 \u2026 1")));
  EXPECT_THAT(reason(read_typed(alpha, "x")), AllOf(HasSubstr("alpha"), HasSubstr("0 \u2026 1")));
}

TEST(TypedNumber, AWholeNumberHasNoFractionAndNoComma) {
  const Parameter& pups = *find_parameter("pups");
  EXPECT_EQ(number(read_typed(pups, "250")), 250) << "beyond the slider's end";
  EXPECT_THAT(reason(read_typed(pups, "2.5")), HasSubstr("whole number"));
  EXPECT_THAT(reason(read_typed(pups, "1,000")), HasSubstr("comma"));
}

TEST(TypedNumber, ANamedNumberHasTheEndsThatItIsGiven) {
  EXPECT_EQ(number(read_typed("speed", 0.5, 1000, "1000")), 1000);
  EXPECT_THAT(reason(read_typed("speed", 0.5, 1000, "1001")),
              AllOf(HasSubstr("speed"), HasSubstr("0.5 \u2026 1000")));
}

}  // namespace
}  // namespace pupflow::window
