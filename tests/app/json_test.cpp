#include "app/io/json.h"

#include <gtest/gtest.h>

#include <limits>

namespace pupflow::io {
namespace {

TEST(Json, StringsAreQuotedAndEscaped) {
  EXPECT_EQ(json_string("a \"b\" \\ θ"), "\"a \\\"b\\\" \\\\ θ\"");
}

TEST(Json, HasNoNumberThatIsNotFinite) {
  EXPECT_EQ(json_number(0.1), "0.1");
  EXPECT_EQ(json_number(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(json_number(-std::numeric_limits<double>::infinity()), "null");
}

TEST(Json, ObjectsAreOneALine) {
  constexpr std::string_view kNames[] = {"a", "b"};
  EXPECT_EQ(json_objects({{{"x", json_strings(kNames)}, {"y", json_bool(true)}}, {{"x", "1"}}}),
            "[\n  {\"x\": [\"a\", \"b\"], \"y\": true},\n  {\"x\": 1}\n]\n");
  EXPECT_EQ(json_strings({}), "[]");
}

}  // namespace
}  // namespace pupflow::io
