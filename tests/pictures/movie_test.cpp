// Films of a litter.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/io/child.h"
#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/machine.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "app/pictures/render.h"
#include "tests/pictures/as_program.h"
#include "tests/pictures/gl_test.h"
#include "tests/support/scratch.h"

namespace pupflow::pictures {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

RenderJob small_job(const test::Scratch& folder) {
  RenderJob job;
  job.at = {10, 20, 30, 40};
  job.width = 321;
  job.height = 240;
  job.fps = 20;
  job.output = {folder.path("film.mp4"), false, true};
  return job;
}

io::Failure failure_of(const RenderJob& job) {
  try {
    render(job);
  } catch (const io::Failure& failure) {
    return failure;
  }
  return {io::ExitCode::done, ""};
}

std::string output_of(const std::string& program, const std::vector<std::string>& arguments) {
  const io::ChildEnd end = io::run_child({io::program_path(program), arguments, "/", {}});
  EXPECT_EQ(end.status, 0) << end.last_words;
  return end.last_words;
}

TEST(Movie, HasThePictureOfEachStep) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  render(job);
  EXPECT_EQ(folder.entries(), 1);
  output_of("ffmpeg", {"-v", "error", "-i", job.output.path, folder.path("film%d.png")});
  EXPECT_EQ(folder.entries(), 1 + 4);
  job.fps = 0;
  job.output.path = folder.path("picture%d.png");
  render(job);
  for (int i = 1; i <= 4; ++i) {
    const io::Image film = io::read_png(folder.path("film" + std::to_string(i) + ".png"));
    const io::Image picture =
        io::read_png(folder.path("picture" + std::to_string(10 * i) + ".png"));
    ASSERT_EQ(film.width, picture.width + 1);
    ASSERT_EQ(film.height, picture.height);
    double difference = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        for (int c = 0; c < 3; ++c) {
          difference += std::abs(film.pixel(x, y)[c] - picture.pixel(x, y)[c]);
        }
      }
    }
    EXPECT_LT(difference / (3.0 * picture.width * picture.height), 3) << i;
  }
}

TEST(Movie, CarriesWhatMadeItAsAFileThatLikeReads) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.params.seed = 7;
  job.look.scale.set_ends(view::Ends::automatic);
  render(job);
  const std::string comment =
      output_of("ffprobe", {"-v", "error", "-show_entries", "format_tags=comment", "-of",
                            "default=nokey=1:noprint_wrappers=1", job.output.path});
  const io::TextEntries entries = io::read_csv_header(folder.file("comment.txt", comment));
  EXPECT_EQ(io::params_from(entries, "film"), job.params);
  EXPECT_THAT(entries, Contains(Pair("scale", "auto")));
  EXPECT_THAT(entries, Contains(Pair("fps", "20")));
  EXPECT_THAT(entries, Contains(Pair("frames", "4")));
  EXPECT_THAT(entries, Contains(Pair("last_step", "40")));
  EXPECT_THAT(entries, Contains(Pair("size", "321x240")));
}

TEST(Movie, WithoutFfmpegItsFramesArePictures) {
  const test::Scratch folder;
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder.path("").c_str(), 1);
  testing::internal::CaptureStderr();
  render(small_job(folder));
  const std::string note = testing::internal::GetCapturedStderr();
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_THAT(note, HasSubstr("apt install ffmpeg"));
  EXPECT_EQ(std::count(note.begin(), note.end(), '\n'), 1);
  EXPECT_EQ(folder.entries(), 1);
  for (const char* name : {"00010.png", "00020.png", "00030.png", "00040.png"}) {
    EXPECT_EQ(io::read_png(folder.path("film_frames/" + std::string(name))).width, 321);
  }
}

TEST(Movie, BadNumbersLeaveNone) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.params.gravity = 1e308;
  job.at.insert(job.at.begin(), 0);
  const io::Failure failure = failure_of(job);
  EXPECT_EQ(failure.code(), io::ExitCode::bad_numbers);
  EXPECT_THAT(failure.what(), HasSubstr("no film was written"));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Movie, AnInterruptLeavesNone) {
  GTEST_FLAG_SET(death_test_style, "fast");
  const test::Scratch folder;
  const RenderJob job = small_job(folder);
  EXPECT_EXIT(test::end_interrupted([&] { render(job); }), ::testing::ExitedWithCode(130),
              "no film was written");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Movie, RefusesWhatAFilmCannotHave) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.look.transparent = true;
  EXPECT_EQ(failure_of(job).code(), io::ExitCode::bad_input);
  job = small_job(folder);
  job.output.path = folder.path("film.png");
  EXPECT_EQ(failure_of(job).code(), io::ExitCode::bad_input);
  job = small_job(folder);
  folder.file("film.mp4", "precious");
  EXPECT_EQ(failure_of(job).code(), io::ExitCode::bad_file);
  EXPECT_EQ(test::contents(folder.path("film.mp4")), "precious");
}

}  // namespace
}  // namespace pupflow::pictures
