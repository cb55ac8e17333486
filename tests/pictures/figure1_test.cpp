#include "app/pictures/figure1.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include "app/gl/renderer.h"
#include "app/io/failure.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "app/view/color_scale.h"
#include "pupflow/simulation.h"
#include "tests/pictures/gl_test.h"
#include "tests/support/scratch.h"

namespace pupflow::pictures {
namespace {

using view::Rgb;

Figure1Job small_job(const test::Scratch& folder) {
  Figure1Job job;
  job.params.steps = 600;
  job.panel = 160;
  job.output = {folder.path("figure1.png"), false, true};
  return job;
}

struct Span {
  int begin, end;
};

/// The arenas: wide stretches of the row through the panels' middle that are not paper.
std::vector<Span> arenas(const io::Image& image, int row) {
  std::vector<Span> spans;
  const Rgb paper{255, 255, 255};
  for (int x = 0; x < image.width; ++x) {
    if (color_at(image, x, row) == paper) continue;
    const int begin = x;
    while (x < image.width && color_at(image, x, row) != paper) ++x;
    if (x - begin > 100) spans.push_back({begin, x});
  }
  return spans;
}

/// How strongly colored a pixel is: floor, rim and paper are grey.
bool is_colored(Rgb c) {
  return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) > 30;
}

/// Where on the map's way the hue of a shaded color lies, in 0 ... 1.
double place_on(view::Colormap map, Rgb c) {
  std::size_t best = 0;
  double best_angle = -1;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Rgb m = map[i];
    const double dot = c.r * m.r + c.g * m.g + c.b * m.b;
    const double angle = dot / std::sqrt((c.r * c.r + c.g * c.g + c.b * c.b + 1e-9) *
                                         (m.r * m.r + m.g * m.g + m.b * m.b + 1e-9));
    if (angle > best_angle) best_angle = angle, best = i;
  }
  return (static_cast<double>(best) + 0.5) / 256;
}

/// The middle one of the body temperatures that a panel's pixels stand for; `share` gets the part
/// of the panel that pups cover.
double temperature_shown(const io::Image& image, Span panel, int row, double& share) {
  const int half = (panel.end - panel.begin) / 2;
  std::vector<double> places;
  for (int y = row - half; y < row + half; ++y) {
    for (int x = panel.begin; x < panel.end; ++x) {
      const Rgb color = color_at(image, x, y);
      if (is_colored(color)) places.push_back(place_on(view::find_colormap("viridis"), color));
    }
  }
  share = static_cast<double>(places.size()) / (4.0 * half * half);
  if (places.empty()) return std::nan("");
  std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2));
  return places[places.size() / 2];
}

double mean_tb_after_run(Params params, double ta) {
  params.ambient_temperature = ta;
  Simulation simulation(params);
  EXPECT_TRUE(simulation.run(params.steps).ok());
  const auto tb = simulation.view().tb;
  return std::accumulate(tb.begin(), tb.end(), 0.0) / static_cast<double>(tb.size());
}

TEST(Figure1, PanelsShowTheLittersTemperatures) {
  const test::Scratch folder;
  const Figure1Job job = small_job(folder);
  figure1(job);
  const io::Image image = io::read_png(job.output.path);
  const int row = image.height - 7 - job.panel / 2;  // the lower margin is 0.8 x 9 pixels
  const auto panels = arenas(image, row);
  ASSERT_EQ(panels.size(), 3u);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    EXPECT_NEAR(panels[i].end - panels[i].begin, job.panel / 1.04, 3);
    double share = 0;
    const double shown = temperature_shown(image, panels[i], row, share);
    // A median over what is seen against a mean over pups, whose T_b spread by some 0.06.
    EXPECT_NEAR(shown, mean_tb_after_run(job.params, job.ta[i]), 0.05);
    // Twelve discs of radius 0.3 in a square of 4.12, less what overlaps.
    EXPECT_GT(share, 0.08);
    EXPECT_LT(share, 0.21);
  }
}

TEST(Figure1, BarHasTheColorsOfTheMap) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 0;
  job.panel = 400;
  job.look.scale.set_map("inferno");
  figure1(job);
  const io::Image image = io::read_png(job.output.path);
  const view::ColorScale scale("inferno", 0, 1);
  const int left = arenas(image, image.height / 2).back().end;
  // The bar's column: where nearly all of the rows within the bar are colors of the map.
  int best = 0;
  std::vector<Rgb> bar;
  for (int x = left; x < image.width; ++x) {
    std::vector<Rgb> column;
    for (int y = 0; y < image.height; ++y) {
      const Rgb color = color_at(image, x, y);
      if (std::ranges::find(scale.map, color) != scale.map.end()) column.push_back(color);
    }
    if (static_cast<int>(column.size()) > best) {
      best = static_cast<int>(column.size());
      bar = column;
    }
  }
  ASSERT_GT(best, 300);
  EXPECT_EQ(bar.front(), scale.map.back());
  EXPECT_EQ(bar.back(), scale.map.front());
  for (std::size_t i = 0; i < bar.size(); ++i) {
    const double value = 1 - (static_cast<double>(i) + 0.5) / static_cast<double>(bar.size());
    const auto at = std::ranges::find(scale.map, bar[i]) - scale.map.begin();
    EXPECT_NEAR(static_cast<double>(at) / 256, value, 0.015) << i;
  }
}

TEST(Figure1, CarriesItsParameters) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 3;
  job.params.seed = 77;
  job.params.rigidity = 0.1 + 0.2;
  job.ta = {0.25, 0.75};
  figure1(job);
  const auto text = io::read_png_text(job.output.path);
  EXPECT_EQ(io::params_from(text, "figure"), job.params);
  EXPECT_THAT(text, ::testing::Contains(::testing::Pair("panels_ta", "0.25,0.75")));
  EXPECT_THAT(text, ::testing::Contains(::testing::Pair("colormap", "viridis")));
}

TEST(Figure1, PanelsShareOneScaleFromTheDataOfAll) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 100;
  job.look.scale = view::ColorScale(*find_field("deformation"));
  const auto scale_of = [&](const std::vector<double>& ta) {
    job.ta = ta;
    job.output.force = true;
    figure1(job);
    for (const auto& [key, value] : io::read_png_text(job.output.path)) {
      if (key == "scale") return std::stod(value.substr(value.find(',') + 1));
    }
    return 0.0;
  };
  const double both = scale_of({0.2, 0.8});
  EXPECT_GT(both, 0);
  EXPECT_EQ(both, std::max(scale_of({0.2}), scale_of({0.8})));
}

TEST(Figure1, ACaptionIsInTheCornersOfEachPanel) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 50;
  job.panel = 300;
  const auto ink_in_corners = [&](bool caption) {
    job.look.caption = caption;
    job.output.force = true;
    figure1(job);
    const io::Image image = io::read_png(job.output.path);
    const int top = image.height - 13 - job.panel;  // the margin is 0.8 x 300 / 18 pixels
    int ink = 0;
    for (int panel = 0; panel < 3; ++panel) {
      for (int y = top; y < top + 30; ++y) {
        for (int x = 0; x < 40; ++x) {
          ink += color_at(image, 13 + panel * (job.panel + 13) + x, y) != Rgb{255, 255, 255};
        }
      }
    }
    return ink;
  };
  const int without = ink_in_corners(false);
  EXPECT_GT(ink_in_corners(true), without + 100);
}

TEST(Figure1, SameJobSamePixels) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 120;
  figure1(job);
  const auto first = io::read_png(job.output.path).rgba;
  job.output.force = true;
  figure1(job);
  EXPECT_EQ(io::read_png(job.output.path).rgba, first);
}

TEST(Figure1, ManyPanelsGoToRows) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 0;
  job.ta = {0, 0.1, 0.2, 0.3, 0.4, 0.5};
  figure1(job);
  const io::Image image = io::read_png(job.output.path);
  const int lower = image.height - 7 - job.panel / 2;
  EXPECT_EQ(arenas(image, lower).size(), 3u);
  EXPECT_EQ(arenas(image, lower - job.panel - 7 - 15).size(), 3u);
}

io::ExitCode code_of(const Figure1Job& job) {
  try {
    figure1(job);
  } catch (const io::Failure& failure) {
    return failure.code();
  }
  return io::ExitCode::done;
}

TEST(Figure1, RefusesBadInput) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.ta = {};
  EXPECT_EQ(code_of(job), io::ExitCode::bad_input);
  job = small_job(folder);
  job.panel = 20;
  EXPECT_EQ(code_of(job), io::ExitCode::bad_input);
  job = small_job(folder);
  job.look.supersample = -1;
  EXPECT_EQ(code_of(job), io::ExitCode::bad_input);
  job = small_job(folder);
  job.look.overlays = view::OverlaySet::parse("trails");
  EXPECT_EQ(code_of(job), io::ExitCode::bad_input);
  job = small_job(folder);
  job.ta = {0.2, std::nan("")};
  EXPECT_EQ(code_of(job), io::ExitCode::bad_input);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Figure1, KeepsWhatExistsUnlessForced) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.steps = 1;
  std::ofstream(job.output.path) << "precious";
  EXPECT_EQ(code_of(job), io::ExitCode::bad_file);
  std::ifstream in(job.output.path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "precious");
  job.output.force = true;
  EXPECT_EQ(code_of(job), io::ExitCode::done);
  EXPECT_GT(io::read_png(job.output.path).width, 0);
}

TEST(Figure1, BadNumbersLeaveNoFigure) {
  const test::Scratch folder;
  Figure1Job job = small_job(folder);
  job.params.gravity = 1e308;
  EXPECT_EQ(code_of(job), io::ExitCode::bad_numbers);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace pupflow::pictures
