#include "app/pictures/render.h"

#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/io/failure.h"
#include "app/io/named_field.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "tests/pictures/as_program.h"
#include "tests/pictures/gl_test.h"
#include "tests/support/scratch.h"

namespace pupflow::pictures {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RenderJob small_job(const test::Scratch& folder) {
  RenderJob job;
  job.at = {0, 20, 40};
  job.width = 320;
  job.height = 240;
  job.output = {folder.path("%04d.png"), false, true};
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

TEST(Render, WritesAFrameForEachStep) {
  const test::Scratch folder;
  const RenderJob job = small_job(folder);
  render(job);
  EXPECT_EQ(folder.entries(), 3);
  std::vector<std::vector<std::uint8_t>> frames;
  for (const char* name : {"0000.png", "0020.png", "0040.png"}) {
    const io::Image image = io::read_png(folder.path(name));
    EXPECT_EQ(image.width, 320);
    EXPECT_EQ(image.height, 240);
    frames.push_back(image.rgba);
  }
  EXPECT_NE(frames[0], frames[1]);
  EXPECT_NE(frames[1], frames[2]);
}

TEST(Render, AFrameDoesNotDependOnTheFramesBefore) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  render(job);
  job.at = {40};
  job.output.path = folder.path("alone.png");
  render(job);
  EXPECT_EQ(io::read_png(folder.path("alone.png")).rgba,
            io::read_png(folder.path("0040.png")).rgba);
}

TEST(Render, AutomaticScalesMoveEvenlyThroughASequence) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.look.scale.set_ends(view::Ends::automatic);
  job.params.ambient_temperature = 0.2;
  job.at = {10, 20, 400};
  const auto top_of = [&](const char* name) {
    for (const auto& [key, value] : io::read_png_text(folder.path(name))) {
      if (key == "scale") return std::stod(value.substr(value.find(',') + 1));
    }
    return 0.0;
  };
  render(job);
  const double first = top_of("0010.png"), next = top_of("0020.png"), last = top_of("0400.png");
  job.at = {20};
  job.output.force = true;
  render(job);
  const double alone = top_of("0020.png");
  EXPECT_LT(alone, first);
  EXPECT_GT(next, alone) << "on its way";
  EXPECT_LT(next, first);
  EXPECT_LT(last, next);
}

TEST(Render, CarriesParametersAndStep) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.params.seed = 5;
  job.params.ambient_temperature = 0.31;
  job.camera = view::Camera::parse("orbit:10,20,9");
  render(job);
  const auto text = io::read_png_text(folder.path("0020.png"));
  EXPECT_EQ(io::params_from(text, "frame"), job.params);
  EXPECT_THAT(text, ::testing::Contains(::testing::Pair("step", "20")));
  EXPECT_THAT(text, ::testing::Contains(::testing::Pair("camera", "orbit:10,20,9")));
}

TEST(Render, CarriesTheFieldThatTheColorsShow) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.at = {40};
  const auto text_of = [&](const char* field) {
    job.look.scale = view::ColorScale(*find_field(field));
    job.output.force = true;
    render(job);
    return io::read_png_text(folder.path("0040.png"));
  };
  using ::testing::Contains;
  using ::testing::Pair;
  const auto tb = text_of("tb");
  EXPECT_THAT(tb, Contains(Pair("color_by", "tb")));
  EXPECT_THAT(tb, Contains(Pair("colormap", "viridis")));
  EXPECT_THAT(tb, Contains(Pair("scale", "0,1")));
  const auto turn = text_of("turn");
  EXPECT_THAT(turn, Contains(Pair("color_by", "turn")));
  EXPECT_THAT(turn, Contains(Pair("colormap", "bluered")));
  const auto group = text_of("group");
  EXPECT_THAT(group, Contains(Pair("color_by", "group")));
  EXPECT_THAT(group, Not(Contains(Pair("scale", ::testing::_))));
}

/// The different colors of a picture's part from column `begin` on.
std::size_t colors_from(const io::Image& image, int begin) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (int y = 0; y < image.height; ++y) {
    for (int x = begin; x < image.width; ++x) {
      const view::Rgb c = color_at(image, x, y);
      colors.insert({c.r, c.g, c.b});
    }
  }
  return colors.size();
}

TEST(Render, EveryFieldHasItsLegendAndKeepsThePositions) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.at = {40};
  job.output.force = true;
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      job.look.scale = view::ColorScale(field);
      job.bar = true;
      render(job);
      const io::Image with = io::read_png(folder.path("0040.png"));
      EXPECT_GT(colors_from(with, 270), 8u) << field.name;
      job.bar = false;
      render(job);
      const io::Image without = io::read_png(folder.path("0040.png"));
      int gray = 0;  // what is not known is gray: after a step all fields are known
      for (int y = 0; y < without.height; ++y) {
        for (int x = 0; x < without.width; ++x) {
          gray += color_at(without, x, y) == view::kUnknownColor;
        }
      }
      EXPECT_LT(gray, 5) << field.name;
    }
  }
}

TEST(Render, WithoutTheBarTheArenaGetsAllTheRoom) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.params.pups = 0;
  job.camera = view::Camera::parse("top");
  job.at = {0};
  job.width = 300;
  job.height = 300;
  const auto arena_width = [&](bool bar) {
    job.bar = bar;
    job.output.force = true;
    render(job);
    const io::Image image = io::read_png(folder.path("0000.png"));
    int width = 0;
    while (width < 300 && color_at(image, width, 150) == view::Rgb{255, 255, 255}) ++width;
    const int begin = width;
    while (width < 300 && color_at(image, width, 150) != view::Rgb{255, 255, 255}) ++width;
    return width - begin;
  };
  EXPECT_NEAR(arena_width(false), 300 / 1.04, 2);
  EXPECT_LT(arena_width(true), 250);
}

TEST(Render, TheFrameTakesInTheWholeLitter) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.camera = view::Camera::parse("side");
  job.bar = false;
  const auto rows_above_the_litter = [&](std::int64_t step) {
    job.at = {step};
    job.output = {folder.path("side.png"), true, true};
    render(job);
    const io::Image image = io::read_png(job.output.path);
    const view::Rgb paper{255, 255, 255};
    int pixel = 0;
    while (color_at(image, pixel % image.width, pixel / image.width) == paper) ++pixel;
    return pixel / image.width;
  };
  job.params.pups = 10;
  job.params.arena_radius = 0.35;  // room for one beside the other
  job.params.start = Start::carpet;
  EXPECT_GT(rows_above_the_litter(0), 0);  // ten layers
  job.params.start = Start::column;
  job.params.start_spread = 0.2;
  EXPECT_GT(rows_above_the_litter(1500), 0);  // the heap after the fall
  job.params.arena_radius = 2;
  job.params.gravity = 0;
  EXPECT_GT(rows_above_the_litter(0), 0);  // a column that stays
}

TEST(Render, TheLegendStepsAsideWhereThePictureIsNarrow) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.at = {0};
  job.look.caption = true;
  job.look.overlays = view::OverlaySet::parse("ids,groups");
  for (const auto& [width, height] : {std::pair{64, 64}, {16, 16}, {100, 900}, {900, 64}}) {
    job.width = width;
    job.height = height;
    job.output.force = true;
    EXPECT_EQ(failure_of(job).code(), io::ExitCode::done) << width << "x" << height;
    EXPECT_EQ(io::read_png(folder.path("0000.png")).width, width);
  }
  // Nothing is cut off at the right: neither legend nor caption nor scale bar reach the edge.
  job.width = 330;
  job.height = 900;
  render(job);
  const io::Image image = io::read_png(folder.path("0000.png"));
  for (int y = 0; y < image.height; ++y) {
    EXPECT_EQ(color_at(image, image.width - 1, y), (view::Rgb{255, 255, 255})) << y;
  }
}

TEST(Render, TheLegendStepsAsideWhereThePictureIsLow) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.at = {0};
  job.output.force = true;
  job.width = 300;
  for (const int height : {32, 60, 100, 150, 200}) {
    for (const char* field : {"tb", "group", "heading", "side"}) {
      job.height = height;
      job.look.scale = view::ColorScale(io::named_field(field, "field"));
      render(job);
      const io::Image image = io::read_png(folder.path("0000.png"));
      for (int x = 225; x < image.width; ++x) {  // where no pup is: words that are cut off
        EXPECT_EQ(color_at(image, x, 0), (view::Rgb{255, 255, 255})) << field << height << ' ' << x;
        EXPECT_EQ(color_at(image, x, height - 1), (view::Rgb{255, 255, 255})) << field << height;
      }
    }
  }
}

TEST(Render, MakesTheFolderOfNumberedFrames) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.output.path = folder.path("new/frames/%05d.png");
  render(job);
  EXPECT_TRUE(std::filesystem::exists(folder.path("new/frames/00040.png")));
}

TEST(Render, RefusesBadInputBeforeAnyFrame) {
  const test::Scratch folder;
  const auto expect_bad = [&](auto change, const char* word) {
    RenderJob job = small_job(folder);
    change(job);
    const io::Failure what = failure_of(job);
    EXPECT_EQ(what.code(), io::ExitCode::bad_input) << what.what();
    EXPECT_THAT(what.what(), HasSubstr(word));
  };
  expect_bad([](RenderJob& job) { job.look.supersample = 100; }, "100");
  expect_bad([](RenderJob& job) { job.width = 0; }, "0x240");
  expect_bad([](RenderJob& job) { job.height = 100000; }, "100000");
  expect_bad([](RenderJob& job) { job.at = {}; }, "steps");
  expect_bad([](RenderJob& job) { job.at = {-1, 3}; }, "steps");
  expect_bad([&](RenderJob& job) { job.output.path = folder.path("one.png"); }, "%05d");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Render, LooksForExistingFramesBeforeTheFirstStep) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  std::ofstream(folder.path("0040.png")) << "precious";
  EXPECT_EQ(failure_of(job).code(), io::ExitCode::bad_file);
  EXPECT_EQ(folder.entries(), 1);
  job.output.force = true;
  EXPECT_EQ(failure_of(job).code(), io::ExitCode::done);
  EXPECT_EQ(folder.entries(), 3);
}

TEST(Render, BadNumbersKeepTheFramesSoFar) {
  const test::Scratch folder;
  RenderJob job = small_job(folder);
  job.params.gravity = 1e308;
  const io::Failure what = failure_of(job);
  EXPECT_EQ(what.code(), io::ExitCode::bad_numbers);
  EXPECT_THAT(what.what(), HasSubstr("1 of 3 frames"));
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(io::read_png(folder.path("0000.png")).width, 320);
}

TEST(Render, AnInterruptKeepsTheFramesSoFar) {
  GTEST_FLAG_SET(death_test_style, "fast");
  const test::Scratch folder;
  const RenderJob job = small_job(folder);
  EXPECT_EXIT(test::end_interrupted([&] { render(job); }), ::testing::ExitedWithCode(130),
              "1 of 3 frames");
  EXPECT_EQ(folder.entries(), 1);
  EXPECT_EQ(io::read_png(folder.path("0000.png")).height, 240);
}

}  // namespace
}  // namespace pupflow::pictures
