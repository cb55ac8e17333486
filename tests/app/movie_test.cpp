#include "app/io/movie.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/io/failure.h"
#include "app/io/machine.h"
#include "app/io/provenance.h"
#include "tests/app/failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using pupflow::test::contents;
using pupflow::test::failure_of;
using pupflow::test::Scratch;
using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr int kWidth = 65, kHeight = 49;  // odd

/// A frame of one color, with a red stripe at the left.
Image frame(std::uint8_t green) {
  Image image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = x < 16 ? 255 : 0;
      pixel[1] = x < 16 ? 0 : green;
      pixel[2] = 0;
      pixel[3] = 255;
    }
  }
  return image;
}

class AMovie : public ::testing::Test {
 protected:
  /// What a program of ffmpeg prints.
  std::string output_of(const std::string& program, const std::vector<std::string>& arguments) {
    const ChildEnd end = run_child({program_path(program), arguments, scratch_.path(""), {}});
    EXPECT_EQ(end.status, 0) << end.last_words;
    return end.last_words;
  }

  std::string probe(const std::string& path, const std::string& entries) {
    return output_of("ffprobe", {"-v", "error", "-count_frames", "-show_entries", entries, "-of",
                                 "default=nokey=1:noprint_wrappers=1", path});
  }

  /// The last frame of a film.
  Image last_frame(const std::string& path) {
    output_of("ffmpeg", {"-v", "error", "-y", "-i", path, "-update", "1", "last.png"});
    return read_png(scratch_.path("last.png"));
  }

  static MovieFile::Options options() {
    return {.width = kWidth,
            .height = kHeight,
            .fps = 25,
            .text = {{"Software", "pupflow test"}, {"ta", "0.25"}, {"picture", "movie"}},
            .force = false};
  }

  std::string film(const std::string& name, int frames) {
    std::string path = scratch_.path(name);
    MovieFile movie(path, options());
    for (int i = 0; i < frames; ++i) movie.add(frame(static_cast<std::uint8_t>(25 * i)));
    movie.finish();
    return path;
  }

  const Scratch scratch_;
};

TEST_F(AMovie, HasEveryFrameInItsColors) {
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    const std::string path = film(name, 8);
    const std::string numbers = probe(path, "stream=r_frame_rate,nb_read_frames");
    EXPECT_THAT(numbers, HasSubstr("25/1")) << name;
    EXPECT_THAT(numbers, HasSubstr("\n8\n")) << name;
    const Image last = last_frame(path);
    EXPECT_LE(last.width - kWidth, 1) << name;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(last.pixel(50, 20)[c], c == 1 ? 175 : 0, 6) << name << ' ' << c;
      EXPECT_NEAR(last.pixel(5, 20)[c], c == 0 ? 255 : 0, 6) << name << ' ' << c;
    }
  }
}

TEST_F(AMovie, CarriesItsEntriesAsAComment) {
  const std::string comment = movie_comment(options().text);
  EXPECT_EQ(comment, "# Software = pupflow test\n# ta = 0.25\n# picture = movie\n");
  EXPECT_THAT(probe(film("a.mp4", 2), "format_tags=comment"), HasSubstr(comment));
  EXPECT_THAT(probe(film("a.webm", 2), "format_tags=comment"), HasSubstr(comment));
  const std::string block = "\x21\xfe" + std::string(1, static_cast<char>(comment.size())) +
                            comment + std::string(1, '\0') + ";";
  EXPECT_THAT(contents(film("a.gif", 2)), EndsWith(block));
}

TEST_F(AMovie, OfALongCommentIsStillAGif) {
  MovieFile::Options many = options();
  many.text.emplace_back("at", std::string(10'000, 'x'));
  const std::string path = scratch_.path("a.gif");
  MovieFile movie(path, many);
  for (int i = 0; i < 3; ++i) movie.add(frame(100));
  movie.finish();
  EXPECT_EQ(last_frame(path).width, kWidth);
  many.text.emplace_back("at", std::string(200'000, 'x'));
  EXPECT_THAT(failure_of(ExitCode::bad_input, [&] { MovieFile(scratch_.path("b.mp4"), many); }),
              HasSubstr("carries at most"));
}

TEST_F(AMovie, IsThereWholeOrNotAtAll) {
  {
    MovieFile movie(scratch_.path("a.mp4"), options());
    movie.add(frame(0));
    EXPECT_EQ(scratch_.entries(), 1);  // the one aside
    EXPECT_FALSE(std::filesystem::exists(scratch_.path("a.mp4")));
  }
  EXPECT_EQ(scratch_.entries(), 0);
}

TEST_F(AMovie, KeepsWhatExistsUnlessForced) {
  const std::string path = scratch_.file("a.gif", "precious");
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { MovieFile(path, options()); }),
              HasSubstr("--force"));
  EXPECT_EQ(contents(path), "precious");
}

/// Puts a program called ffmpeg before the real one.
class AnotherFfmpeg {
 public:
  AnotherFfmpeg(const Scratch& scratch, const std::string& script) : before_(std::getenv("PATH")) {
    std::filesystem::create_directory(scratch.path("bin"));
    std::filesystem::permissions(scratch.file("bin/ffmpeg", "#!/bin/sh\n" + script + "\n"),
                                 std::filesystem::perms::owner_all);
    ::setenv("PATH", (scratch.path("bin") + ":/usr/bin:/bin").c_str(), 1);
  }
  ~AnotherFfmpeg() { ::setenv("PATH", before_.c_str(), 1); }
  AnotherFfmpeg(const AnotherFfmpeg&) = delete;
  AnotherFfmpeg& operator=(const AnotherFfmpeg&) = delete;

 private:
  std::string before_;
};

TEST_F(AMovie, ThatFailsHasTheLastWordsOfFfmpeg) {
  const auto failure = [&](const std::string& script) {
    const AnotherFfmpeg ffmpeg(scratch_, script);
    const std::string text = failure_of(ExitCode::bad_file, [&] {
      MovieFile movie(scratch_.path("a.mp4"), options());
      for (int i = 0; i < 100; ++i) movie.add(frame(0));
      movie.finish();
    });
    std::filesystem::remove_all(scratch_.path("bin"));
    EXPECT_EQ(scratch_.entries(), 0);
    return text;
  };
  EXPECT_THAT(failure("echo first >&2; echo Unknown encoder >&2; exit 1"),
              HasSubstr("a.mp4: ffmpeg failed with exit code 1 (Unknown encoder)"));
  EXPECT_THAT(failure("cat >/dev/null; exit 3"), HasSubstr("exit code 3 (it left no message)"));
  EXPECT_THAT(failure("cat >/dev/null; echo No space left >&2"), HasSubstr("(No space left)"));
  EXPECT_THAT(failure("kill -9 $$"), HasSubstr("exit code 137"));
}

TEST(Movie, RefusesNamesAndSizesThatCannotBe) {
  const auto refused = [](const std::string& path, int fps, int width, int height) {
    return failure_of(ExitCode::bad_input, [&] { check_movie(path, fps, width, height); });
  };
  EXPECT_THAT(refused("a.avi", 25, 64, 64), HasSubstr(".mp4, .webm or .gif"));
  EXPECT_THAT(refused("mp4", 25, 64, 64), HasSubstr("must end in"));
  EXPECT_THAT(refused("a.gif", 60, 64, 64), HasSubstr("1 to 50"));
  EXPECT_THAT(refused("a.mp4", 0, 64, 64), HasSubstr("1 to 120"));
  EXPECT_THAT(refused("a.mp4", 25, 16384, 16384), HasSubstr("too large"));
  check_movie("a.mp4", 120, 8192, 4320);
}

}  // namespace
}  // namespace pupflow::io
