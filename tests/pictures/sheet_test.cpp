#include "app/pictures/sheet.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "app/io/failure.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "tests/pictures/gl_test.h"
#include "tests/support/scratch.h"

namespace pupflow::pictures {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr int kPanel = 180, kMargin = 8, kTitle = 17;  // text is 10 pixels: 0.8 and 1.7 of it

SheetJob small_job(const test::Scratch& folder) {
  SheetJob job;
  job.params.steps = 60;
  job.axes = {{"seed", {1, 2, 3}}};
  job.panel = kPanel;
  job.look.scale.set_range(0, 1);
  job.output = {folder.path("grid.png"), false, true};
  job.verb = "render --grid";
  job.entries = {{"picture", "grid"}};
  return job;
}

io::Failure failure_of(const SheetJob& job) {
  try {
    sheet(job);
  } catch (const io::Failure& failure) {
    return failure;
  }
  return {io::ExitCode::done, ""};
}

io::Image drawn(SheetJob job) {
  job.output.force = true;
  sheet(job);
  return io::read_png(job.output.path);
}

/// The pixels of a panel.
std::vector<view::Rgb> panel_of(const io::Image& image, int column, int row) {
  const int left = kMargin + column * (kPanel + kMargin);
  const int top = kMargin + row * (kTitle + kPanel + kMargin) + kTitle;
  std::vector<view::Rgb> pixels;
  for (int y = top; y < top + kPanel; ++y) {
    for (int x = left; x < left + kPanel; ++x) pixels.push_back(color_at(image, x, y));
  }
  return pixels;
}

TEST(Sheet, HasThePictureOfEachSeed) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  const io::Image all = drawn(job);
  for (int i = 0; i < 3; ++i) {
    job.axes = {{"seed", {1.0 + i}}};
    EXPECT_EQ(panel_of(drawn(job), 0, 0), panel_of(all, i, 0)) << i;
  }
  EXPECT_NE(panel_of(all, 0, 0), panel_of(all, 1, 0));
}

TEST(Sheet, OfTwoParametersGoesAcrossAndDown) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.axes = {{"ta", {0.2, 0.8}}, {"pups", {2, 5, 9}}};
  const io::Image table = drawn(job);
  EXPECT_EQ(table.height, kMargin + 3 * (kTitle + kPanel + kMargin));
  job.axes = {{"ta", {0.8}}, {"pups", {5}}};
  EXPECT_EQ(panel_of(drawn(job), 0, 0), panel_of(table, 1, 1));
}

TEST(Sheet, DoesNotDependOnThreads) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  const auto one = drawn(job).rgba;
  job.threads = 3;
  EXPECT_EQ(drawn(job).rgba, one);
}

TEST(Sheet, WithoutTheBarEndsAtItsPanels) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.bar = false;
  EXPECT_EQ(drawn(job).width, kMargin + 3 * (kPanel + kMargin));
}

TEST(Sheet, TheLegendOfOverlaysStandsBelow) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.axes = {{"seed", {1}}};
  const io::Image without = drawn(job);
  job.look.overlays = view::OverlaySet::parse("ids,headings,contacts");
  const io::Image with = drawn(job);
  EXPECT_EQ(with.width, without.width);
  ASSERT_GT(with.height, without.height + 15);
  int ink = 0;
  for (int y = without.height; y < with.height; ++y) {
    for (int x = 0; x < with.width; ++x) ink += color_at(with, x, y).g < 128;
    EXPECT_GT(color_at(with, 0, y).g, 250) << y;
    EXPECT_GT(color_at(with, with.width - 1, y).g, 250) << y;
  }
  EXPECT_GT(ink, 100);
}

TEST(Sheet, PanelsWithScalesOfTheirOwnHaveBars) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.axes = {{"ta", {0.2, 0.8}}};
  job.look.scale = view::ColorScale();
  job.look.scale.set_ends(view::Ends::automatic);
  const io::Image shared = drawn(job);
  job.own_scales = true;
  const io::Image own = drawn(job);
  EXPECT_GT(own.width, shared.width + 30);
  EXPECT_EQ(own.height, shared.height);
  EXPECT_THAT(io::read_png_text(job.output.path), Contains(Pair("scale", "auto")));
  // The first panel alone looks the same, its bar included.
  job.axes = {{"ta", {0.2}}};
  const io::Image first = drawn(job);
  const int top = kMargin + kTitle;
  for (int y = top; y < top + kPanel; ++y) {
    for (int x = 0; x < first.width - kMargin; ++x) {
      ASSERT_EQ(color_at(own, x, y), color_at(first, x, y)) << x << " " << y;
    }
  }
}

TEST(Sheet, CarriesItsGrid) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.params.steps = 3;
  job.axes = {{"ta", {0.2, 0.25}}, {"contact", {0, 2}}};
  sheet(job);
  const auto text = io::read_png_text(job.output.path);
  EXPECT_EQ(io::params_from(text, "sheet"), job.params);
  EXPECT_THAT(text, Contains(Pair("grid", "ta=0.2,0.25 contact=nearest,sum")));
  EXPECT_THAT(text, Contains(Pair("panel", "180")));
  EXPECT_THAT(text, Contains(Pair("camera", "orbit:30,35")));
}

TEST(Sheet, RefusesWhatDoesNotFitBeforeTheFirstStep) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.params.steps = 1'000'000'000;
  const auto refused = [&](const SheetJob& bad) {
    const io::Failure failure = failure_of(bad);
    EXPECT_EQ(failure.code(), io::ExitCode::bad_input);
    return std::string(failure.what());
  };
  SheetJob bad = job;
  bad.axes = {{"seed", std::vector<double>(9, 1)}, {"ta", std::vector<double>(9, 0.5)}};
  bad.panel = kLargestPanel;
  EXPECT_THAT(refused(bad), HasSubstr("too large"));
  bad = job;
  bad.axes = {{"seed", std::vector<double>(101, 1)}};
  EXPECT_THAT(refused(bad), HasSubstr("101 panels"));
  bad = job;
  bad.axes = {};
  EXPECT_THAT(refused(bad), HasSubstr("one or two"));
  bad = job;
  bad.axes = {{"warmth", {1}}};
  EXPECT_THAT(refused(bad), HasSubstr("'warmth'"));
  bad = job;
  bad.axes = {{"ta", {0.5, std::nan("")}}};
  refused(bad);
  bad = job;
  bad.look.overlays = view::OverlaySet::parse("trails");
  EXPECT_THAT(refused(bad), HasSubstr("trails"));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Sheet, BadNumbersNameThePanelAndLeaveNone) {
  const test::Scratch folder;
  SheetJob job = small_job(folder);
  job.axes = {{"gravity", {10, 1e308}}};
  const io::Failure failure = failure_of(job);
  EXPECT_EQ(failure.code(), io::ExitCode::bad_numbers);
  EXPECT_THAT(failure.what(), HasSubstr("gravity = 1e+308"));
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace pupflow::pictures
