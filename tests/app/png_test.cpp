#include "app/io/png.h"

#include <gmock/gmock.h>

#include "app/io/read_file.h"
#include "failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using test::failure_of;
using testing::HasSubstr;

Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = static_cast<std::uint8_t>(7 * x);
      pixel[1] = static_cast<std::uint8_t>(11 * y);
      pixel[2] = static_cast<std::uint8_t>(x * y);
      pixel[3] = 13;  // to be dropped
    }
  }
  return image;
}

TEST(Png, PixelsReadBackOpaque) {
  const test::Scratch scratch;
  const Image image = gradient(37, 21);
  write_png(scratch.path("a.png"), image, {}, false);
  const Image back = read_png(scratch.path("a.png"));
  ASSERT_EQ(back.width, 37);
  ASSERT_EQ(back.height, 21);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    ASSERT_EQ(back.rgba[i], i % 4 == 3 ? 255 : image.rgba[i]) << "byte " << i;
  }
}

TEST(Png, KeepsAlphaAndResolutionWhereAsked) {
  const test::Scratch scratch;
  const Image image = gradient(37, 21);
  write_png(scratch.path("a.png"), image, {}, false, {.alpha = true, .dpi = 300});
  EXPECT_EQ(read_png(scratch.path("a.png")).rgba, image.rgba);
  const std::string bytes = read_file(scratch.path("a.png"), 1 << 20);
  const std::size_t chunk = bytes.find("pHYs");
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_EQ(bytes.substr(chunk + 4, 9),
            std::string("\0\0\x2e\x23\0\0\x2e\x23\1", 9));  // 11811 a metre
}

TEST(Png, TextReadsBackInOrder) {
  const test::Scratch scratch;
  const TextEntries text{
      {"Software", "pupflow"}, {"ta", "0.2"}, {"title", "T\u00e4 \u2026 \u03b1"}, {"empty", ""}};
  write_png(scratch.path("a.png"), gradient(4, 4), text, false);
  EXPECT_EQ(read_png_text(scratch.path("a.png")), text);
}

TEST(Png, RefusesWhatExists) {
  const test::Scratch scratch;
  const std::string path = scratch.file("a.png", "precious");
  failure_of(ExitCode::bad_file, [&] { write_png(path, gradient(4, 4), {}, false); });
  EXPECT_EQ(test::contents(path), "precious");
  write_png(path, gradient(4, 4), {}, true);
  EXPECT_EQ(read_png(path).width, 4);
}

TEST(Png, NamesADamagedFile) {
  const test::Scratch scratch;
  write_png(scratch.path("a.png"), gradient(64, 64), {{"ta", "0.2"}}, false);
  const std::string whole = test::contents(scratch.path("a.png"));
  const std::string half = scratch.file("half.png", whole.substr(0, whole.size() / 2));
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { read_png(half); }), HasSubstr(half));
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { read_png_text(half); }), HasSubstr(half));
  const std::string text = scratch.file("text.png", "no picture");
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { read_png(text); }), HasSubstr(text));
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { read_png_text(text); }), HasSubstr(text));
  failure_of(ExitCode::bad_file, [&] { read_png(scratch.path("none.png")); });
}

}  // namespace
}  // namespace pupflow::io
