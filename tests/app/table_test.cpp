#include "app/io/table.h"

#include <gmock/gmock.h>

#include <limits>

namespace pupflow::io {
namespace {

using testing::ElementsAre;

TEST(Table, ColumnsAreAsWideAsTheirWidestCell) {
  EXPECT_EQ(aligned({{"a", "µs", "c"}, {"long", "1"}, {"", "22", "d"}}),
            "a     µs  c\nlong  1\n      22  d\n");
}

TEST(Table, ABarDoesNotEndACellOfMarkdown) {
  EXPECT_EQ(markdown_table({{"a", "b"}, {"|x|", ""}}), "| a | b |\n|---|---|\n| \\|x\\| | |\n");
}

TEST(Table, ABarIsAsLongAsItsShare) {
  EXPECT_EQ(bar(10, 10), std::string(16, '#'));
  EXPECT_EQ(bar(5, 10), std::string(8, '#'));
  EXPECT_EQ(bar(20, 10), std::string(16, '#'));
  EXPECT_EQ(bar(1, 1000), ".");
  EXPECT_EQ(bar(0, 10), "");
  EXPECT_EQ(bar(1, 0), "");
  EXPECT_EQ(bar(std::numeric_limits<double>::quiet_NaN(), 1), "");
}

TEST(Table, TextIsBrokenBetweenWords) {
  EXPECT_THAT(wrapped("one two three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("µµµ µµµ", 7), ElementsAre("µµµ µµµ"));
  EXPECT_THAT(wrapped("unbreakable words", 4), ElementsAre("unbreakable", "words"));
  EXPECT_THAT(wrapped("", 7), testing::IsEmpty());
}

}  // namespace
}  // namespace pupflow::io
