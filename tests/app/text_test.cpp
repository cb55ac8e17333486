#include "app/io/text.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdlib>
#include <limits>

#include "app/io/frame_path.h"
#include "app/io/nearest.h"
#include "failing.h"

namespace pupflow::io {
namespace {

using test::failure_of;

TEST(Text, NumbersReadBackAndAreShort) {
  for (const double value :
       {0.1, 1.0 / 3, 1e-300, 123456789.125, -0.0, 5e-324, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(std::strtod(number_text(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(12), "12");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Text, PrintableShowsWhatATerminalMayShow) {
  EXPECT_EQ(printable("T_a = 0.2 \xc2\xb1 0.1 \xe2\x82\x82 \xf0\x9f\x90\xad"),
            "T_a = 0.2 \xc2\xb1 0.1 \xe2\x82\x82 \xf0\x9f\x90\xad");
  EXPECT_EQ(printable("a\x1b[31m\tb\n\x7f"), "a\\x1b[31m\\x09b\\x0a\\x7f");
  EXPECT_EQ(printable("a\tb\n\r", "\n\t"), "a\tb\n\\x0d");
  EXPECT_EQ(printable("\xc2\x9b\x9b"), "\\xc2\\x9b\\x9b");  // U+009B begins a sequence
  EXPECT_EQ(printable("\xc0\x9b\xe0\x82\x9b"), "\\xc0\\x9b\\xe0\\x82\\x9b");  // overlong forms
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");                             // cut off
  EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(quoted("a\x1b"), "'a\\x1b'");
}

TEST(Nearest, FindsSlipsAndNothingFarOff) {
  const std::array<std::string_view, 3> names{"alpha", "beta", "arena_radius"};
  EXPECT_EQ(nearest("alpa", names), "alpha");
  EXPECT_EQ(nearest("arena_radios", names), "arena_radius");
  EXPECT_EQ(nearest("zzz", names), "");
  EXPECT_EQ(nearest("", names), "");
  EXPECT_EQ(nearest(std::string(10000, 'a'), names), "");
  EXPECT_EQ(did_you_mean("bet", names), "; did you mean 'beta'?");
  EXPECT_EQ(did_you_mean("zzz", names), "");
}

TEST(FramePath, FillsItsOnePlace) {
  EXPECT_EQ(frame_path("f/%05d.png", 42), "f/00042.png");
  EXPECT_EQ(frame_path("f%d.png", 42), "f42.png");
  EXPECT_EQ(frame_path("%02d", 12345), "12345");
  EXPECT_EQ(frame_path("plain.png", 42), "plain.png");
  EXPECT_TRUE(has_number("f/%05d.png"));
  EXPECT_FALSE(has_number("plain.png"));
}

TEST(FramePath, RefusesAnythingElse) {
  for (const char* pattern :
       {"%s.png", "%d%d.png", "%5d.png", "%n", "100%", "%%.png", "%05", "%05d%", "%00d", "%012d"}) {
    failure_of(ExitCode::bad_input, [&] { has_number(pattern); });
    failure_of(ExitCode::bad_input, [&] { frame_path(pattern, 1); });
  }
}

TEST(Text, IsSplitAtSeparators) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string_view>{"a", "", "b"}));
  EXPECT_EQ(split("", ','), (std::vector<std::string_view>{""}));
}

TEST(Text, IsJoinedWithSeparators) {
  EXPECT_EQ(joined(std::vector<std::string>{"", "a"}, ", "), ", a");
  EXPECT_EQ(joined(std::vector<int>{1, 2}, "+", [](int n) { return std::to_string(n); }), "1+2");
  EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
}

TEST(Text, IsANumberWhenThatIsAll) {
  EXPECT_EQ(read_number<int>("-12"), -12);
  EXPECT_EQ(read_number<double>("1e3"), 1000);
  for (const char* text : {"", " 1", "1 ", "+1", "1x", "1.5"}) {
    EXPECT_EQ(read_number<int>(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace pupflow::io
