#include "app/window/picture_size.h"

#include <gmock/gmock.h>

#include "app/pictures/look.h"

namespace pupflow::window {
namespace {

TEST(PictureSize, IsThatOfTheArenaOrAChosenOne) {
  EXPECT_EQ(PictureSize{}.of({700, 500}), (PixelSize{700, 500}));
  EXPECT_EQ(PictureSize{.times = 2}.of({700, 500}), (PixelSize{1400, 1000}));
  EXPECT_EQ((PictureSize{.pixels = {30, 40}}.of({700, 500})), (PixelSize{30, 40}));
}

TEST(PictureSize, StaysWithinWhatPicturesMayHave) {
  EXPECT_EQ(PictureSize{.times = 2}.of({10'000, 3}),
            (PixelSize{pictures::kLargestSide, pictures::kSmallestSide}));
}

TEST(PictureSize, ReadsWhatPeopleType) {
  for (const char* text : {"1920x1080", " 1920 x 1080 ", "1920\u00d71080", "1920 \u00d7 1080"}) {
    const auto read = read_size(text);
    ASSERT_TRUE(std::holds_alternative<PixelSize>(read)) << text;
    EXPECT_EQ(std::get<PixelSize>(read), (PixelSize{1920, 1080})) << text;
  }
  EXPECT_EQ(std::get<PixelSize>(read_size(size_text({640, 480}))), (PixelSize{640, 480}));
}

TEST(PictureSize, SaysWhatASizeIs) {
  for (const char* text :
       {"", "x", "abc", "100", "0x100", "100x20000", "1x2x3", "-5x100", "1e3x100"}) {
    const auto read = read_size(text);
    ASSERT_TRUE(std::holds_alternative<std::string>(read)) << text;
    EXPECT_THAT(std::get<std::string>(read), testing::HasSubstr("WIDTHxHEIGHT, each 16")) << text;
  }
}

}  // namespace
}  // namespace pupflow::window
