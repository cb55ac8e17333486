#include "app/gl/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "app/io/failure.h"
#include "tests/pictures/renderer_scenes.h"

namespace pupflow::gl {
namespace {

/// Which sphere a pixel shows: 0 blue, 1 red, -1 neither.
int sphere_in(Rgb color) {
  if (color.b > 15 && color.r == 0 && color.g == 0) return 0;
  if (color.r > 15 && color.b == 0 && color.g == 0) return 1;
  return -1;
}

struct Ray {
  Vector start, direction;
};

/// Distance along the ray to the sphere, if it meets it.
std::optional<double> hit(const Ray& ray, const Vector& centre, double radius) {
  const Vector to = centre - ray.start;
  const double along = to.dot(ray.direction);
  const double depth2 = radius * radius - (to - along * ray.direction).squaredNorm();
  if (depth2 < 0) return std::nullopt;
  return along - std::sqrt(depth2);
}

/// Compares a picture with ray casting done here; `ray_through` gives the line of sight through
/// the middle of a pixel. Returns how many pixels show a sphere.
template <class RayThrough>
int compare_with_rays(const io::Image& image, const std::vector<Vector>& centres, double radius,
                      RayThrough ray_through) {
  int wrong = 0, covered = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Ray ray = ray_through(x, y);
      int nearest = -1;
      double distance = 1e300;
      for (std::size_t i = 0; i < centres.size(); ++i) {
        const auto at = hit(ray, centres[i], radius);
        if (at && *at < distance) distance = *at, nearest = static_cast<int>(i) % 2;
      }
      covered += nearest >= 0;
      wrong += sphere_in(color_at(image, x, y)) != nearest;
    }
  }
  EXPECT_LE(wrong, covered / 500 + 4);  // pixels whose middle lies on an outline within rounding
  return covered;
}

TEST_F(RendererTest, TopViewAgreesWithRays) {
  const std::vector<Vector> centres{{0.5, 1.0, 1}, {-1.2, -0.3, 0.6}, {-1.0, -0.3, 0.8}};
  const double radius = 0.3;
  Camera camera = Camera::parse("top");
  camera.frame(2, 1, 1.25);
  const io::Image image =
      take_picture(spheres(centres, radius), kJet, camera, 500, 400, 1, kAllPoints);
  const double unit = 200 / camera.half_height();  // pixels; the arena's height fills the picture
  EXPECT_NEAR(unit * 2 * 1.04, 200, 0.5);
  const int covered = compare_with_rays(image, centres, radius, [&](int x, int y) {
    return Ray{{(x + 0.5 - 250) / unit, (200 - y - 0.5) / unit, 50}, {0, 0, -1}};
  });
  EXPECT_GT(covered, 4000);
}

TEST_F(RendererTest, PerspectiveAgreesWithRays) {
  // Large, close and far off the axis, where a round outline would be wrong; two interpenetrate.
  const std::vector<Vector> centres{
      {0.3, 1.1, 1}, {-0.2, -0.9, 0.7}, {-0.22, -0.62, 0.79}, {1.2, 0.2, 0.4}};
  const double radius = 0.35;
  const Camera camera = Camera::parse("orbit:30,35,4.5");
  const io::Image image =
      take_picture(spheres(centres, radius), kJet, camera, 480, 360, 1, kAllPoints);
  const Vector eye =
      4.5 * Vector(std::cos(35 * kDegrees) * std::cos(30 * kDegrees),
                   std::cos(35 * kDegrees) * std::sin(30 * kDegrees), std::sin(35 * kDegrees));
  const Vector forward = -eye.normalized();
  const Vector right = forward.cross(Vector::UnitZ()).normalized();
  const Vector up = right.cross(forward);
  const double pixel = std::tan(15 * kDegrees) / 180;  // 30 degrees from top to bottom
  const int covered = compare_with_rays(image, centres, radius, [&](int x, int y) {
    const Vector sight = forward + pixel * ((x + 0.5 - 240) * right + (180 - y - 0.5) * up);
    return Ray{eye, sight.normalized()};
  });
  EXPECT_GT(covered, 10000);
}

TEST_F(RendererTest, ASphereCloseToTheEyeKeepsItsWholeOutline) {
  const Camera camera = Camera::parse("orbit:0,0,1.2");
  const Vector centre(0.2, 0.1, 0.05);
  const double radius = 0.22;
  const io::Image image =
      take_picture(spheres({centre}, radius), kJet, camera, 400, 300, 1, kAllPoints);
  const double pixel = std::tan(15 * kDegrees) / 150;
  const int covered = compare_with_rays(image, {centre}, radius, [&](int x, int y) {
    const Vector sight(-1, pixel * (x + 0.5 - 200), pixel * (150 - y - 0.5));
    return Ray{{1.2, 0, 0}, sight.normalized()};
  });
  EXPECT_GT(covered, 50000);
}

TEST_F(RendererTest, MiddleOfASphereHasTheColorOfTheBar) {
  const view::ColorScale viridis("viridis", 0, 1);
  for (const double temperature : {0.05, 0.4, 0.6, 0.95}) {
    Simulation simulation = spheres({{0, 0, 1}}, 0.3);
    simulation.set_body_temperature(0, temperature);
    for (const char* spec : {"top", "orbit:30,35,6"}) {
      Camera camera = Camera::parse(spec);
      camera.frame(2, 1, 1);
      const io::Image image = take_picture(simulation, viridis, camera, 401, 401, 1);
      // The sphere's middle: on the axis from above, else 1 above the point looked at.
      const double lift = spec[0] == 't' ? 0 : 1 * std::cos(35 * kDegrees);
      const double depth = spec[0] == 't' ? 0 : 6 - 1 * std::sin(35 * kDegrees);
      const int up =
          spec[0] == 't' ? 0 : static_cast<int>(200.5 * lift / (depth * std::tan(15 * kDegrees)));
      const Rgb seen = color_at(image, 200, 200 - up), bar = viridis(temperature);
      EXPECT_NEAR(seen.r, bar.r, 2) << spec << temperature;
      EXPECT_NEAR(seen.g, bar.g, 2) << spec << temperature;
      EXPECT_NEAR(seen.b, bar.b, 2) << spec << temperature;
    }
  }
}

TEST_F(RendererTest, ShadingStaysNearTheColorOfTheBar) {
  Params params;
  params.pups = 1;
  Simulation simulation(params);
  Camera camera = Camera::parse("top");
  camera.frame(0.5, 1, 1);
  const io::Image image = take_picture(simulation, kJet, camera, 300, 300, 2);
  simulation.set_body_temperature(0, 1);  // (128, 0, 0)
  const io::Image red = take_picture(simulation, kJet, camera, 300, 300, 2);
  std::vector<int> brightness;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) {
      if (sphere_in(color_at(red, x, y)) == 1) brightness.push_back(red.pixel(x, y)[0]);
    }
  }
  ASSERT_GT(brightness.size(), 5000u);
  std::ranges::sort(brightness);
  EXPECT_GT(brightness[brightness.size() / 2], 0.8 * 128);
  EXPECT_LE(brightness.back(), 128);
}

TEST_F(RendererTest, FloorRimAndBackgroundAreWhereTheyBelong) {
  Params params;
  params.pups = 0;
  Camera camera = Camera::parse("top");
  camera.frame(2 * (1 + view::kRimWidth), 0, 1);
  const Palette palette;
  const io::Image image = take_picture(Simulation(params), kJet, camera, 600, 600, 2);
  const double unit = 300 / camera.half_height();
  const auto at_radius = [&](double radius) {
    return color_at(image, static_cast<int>(300 + unit * radius), 300);
  };
  const auto beside_the_grid = [&](double radius) {
    return color_at(image, static_cast<int>(300 + unit * radius), 300 - 20);
  };
  EXPECT_EQ(beside_the_grid(0.2), palette.floor);
  EXPECT_EQ(beside_the_grid(1.9), palette.floor);
  EXPECT_LT(color_at(image, 300 + static_cast<int>(unit * 0.5), 280).r, palette.floor.r);  // grid
  EXPECT_EQ(at_radius(2.03), palette.slab);
  EXPECT_EQ(at_radius(2.05), palette.slab);
  EXPECT_EQ(at_radius(2.08), palette.background);
}

TEST_F(RendererTest, EdgesOfTheArenaAreSoftWithOneSampleToo) {
  Params params;
  params.pups = 0;
  Camera camera = Camera::parse("top");
  camera.frame(2, 0, 1);
  const io::Image image = take_picture(Simulation(params), kJet, camera, 300, 300, 1);
  const Palette palette;
  int between = 0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) {
      if (std::hypot(x - 150, y - 150) < 130) continue;  // the grid
      const Rgb color = color_at(image, x, y);
      between += color != palette.floor && color != palette.slab && color != palette.background;
    }
  }
  EXPECT_GT(between, 500);   // two circles of some 900 pixels each
  EXPECT_LT(between, 6000);  // each with a line of three
}

int differing_pixels(const io::Image& a, const io::Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) count += color_at(a, x, y) != color_at(b, x, y);
  }
  return count;
}

TEST_F(RendererTest, CullingChangesNoPixel) {
  Params params;
  params.ambient_temperature = 0.2;
  for (const double beta : {0.5, 0.9}) {
    params.deformation = beta;
    Simulation simulation(params);
    for (const std::int64_t step : {60, 140, 500}) {
      ASSERT_TRUE(simulation.run(step - simulation.steps_done()).ok());
      for (const char* spec : {"top", "side", "orbit:30,35", "orbit:200,10,6", "orbit:-70,60,4"}) {
        Camera camera = Camera::parse(spec);
        camera.frame(2, 0.6, 1.25);
        const io::Image all = take_picture(simulation, kJet, camera, 500, 400, 1, kAllPoints);
        const io::Image visible = take_picture(simulation, kJet, camera, 500, 400, 1, kPoints);
        EXPECT_EQ(differing_pixels(all, visible), 0)
            << spec << " after step " << step << ", beta " << beta;
      }
    }
  }
}

TEST_F(RendererTest, MoreSamplesChangeOnlyEdges) {
  Params params;
  Simulation simulation(params);
  simulation.run(300);
  Camera camera = Camera::parse("orbit:30,35");
  camera.frame(2, 0.6, 1);
  const io::Image one = take_picture(simulation, kJet, camera, 400, 400, 1);
  const io::Image many = take_picture(simulation, kJet, camera, 400, 400, 4);
  int changed = 0, flat = 0;
  for (int y = 2; y < 398; ++y) {
    for (int x = 2; x < 398; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        int low = 255, high = 0;
        for (int n = 0; n < 25; ++n) {
          const int value = one.pixel(x + n % 5 - 2, y + n / 5 - 2)[channel];
          low = std::min(low, value), high = std::max(high, value);
        }
        const int change = std::abs(many.pixel(x, y)[channel] - one.pixel(x, y)[channel]);
        changed += change > 12;
        if (high - low > 12) continue;  // an edge is near
        ++flat;
        EXPECT_LE(change, 12) << x << " " << y;
      }
    }
  }
  EXPECT_GT(flat, 100000);
  EXPECT_GT(changed, 300);
}

TEST_F(RendererTest, APixelIsTheMeanOfItsSamples) {
  Simulation simulation((Params()));
  simulation.run(100);
  Camera camera = Camera::parse("orbit:30,-10");
  camera.frame(2, 0.6, 1);
  const io::Image small = take_picture(simulation, kJet, camera, 150, 150, 3);
  const io::Image large = take_picture(simulation, kJet, camera, 450, 450, 1);
  int off = 0;  // the rim is as many pixels wide in either picture
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 150; ++x) {
      double sum = 0;
      for (int n = 0; n < 9; ++n) sum += large.pixel(3 * x + n % 3, 3 * y + n / 3)[0];
      off += std::abs(small.pixel(x, y)[0] - sum / 9) > 1;
    }
  }
  EXPECT_LT(off, 150 * 150 / 15);
}

TEST_F(RendererTest, WherePartsMeetDoesNotShow) {
  // In a picture that is wider by an even number of pixels the parts of many samples meet elsewhere.
  constexpr int kWidth = 640, kHeight = 480, kMore = 50, kRounding = 3;
  Params params;
  params.ambient_temperature = 0.2;
  Simulation simulation(params);
  ASSERT_TRUE(simulation.run(400).ok());
  for (const char* from : {"orbit:80,30,8,30", "orbit:120,30,8,30", "orbit:160,30,8,30"}) {
    const Camera camera = Camera::parse(from);
    const io::Image narrow = take_picture(simulation, kJet, camera, kWidth, kHeight, 8, {});
    const io::Image wide =
        take_picture(simulation, kJet, camera, kWidth + 2 * kMore, kHeight, 8, {});
    int most = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < 3; ++c) {
          most = std::max(most, std::abs(narrow.pixel(x, y)[c] - wide.pixel(x + kMore, y)[c]));
        }
      }
    }
    EXPECT_LE(most, kRounding) << from;
  }
}

TEST_F(RendererTest, DrawsIntoAPartOfTheBoundFramebuffer) {
  const Simulation simulation = spheres({{0, 0, 1}}, 0.3);
  Camera camera = Camera::parse("top");
  camera.frame(2, 1, 1);
  view::DrawList list;
  list.update(simulation, kJet, camera, kPoints);
  Renderer renderer;
  renderer.upload(list);
  const io::Image alone = renderer.picture(camera, 100, 100, 2);
  for (const int supersample : {1, 2}) {
    Target target;
    target.resize(300, 200);
    target.bind();
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer.draw(camera, {150, 40, 100, 100}, supersample);
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    EXPECT_EQ(static_cast<GLuint>(bound), target.framebuffer());
    const io::Image image = target.read();
    EXPECT_EQ(color_at(image, 149, 100), (Rgb{0, 255, 0}));
    EXPECT_EQ(color_at(image, 250, 100), (Rgb{0, 255, 0}));
    EXPECT_EQ(color_at(image, 200, 59), (Rgb{0, 255, 0}));
    EXPECT_EQ(color_at(image, 200, 160), (Rgb{0, 255, 0}));
    EXPECT_EQ(color_at(image, 200, 110), color_at(alone, 50, 50));
  }
}

TEST_F(RendererTest, ASharedPictureCopiesItsPixels) {
  Target source, destination;
  source.resize(20, 10);
  destination.resize(40, 30);
  for (const auto& [target, red] : {std::pair{&source, 1.0f}, std::pair{&destination, 0.0f}}) {
    target->bind();
    glClearColor(red, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  SharedPicture shown;
  shown.show(source.texture(), source.width(), source.height());
  shown.copy_to(destination.framebuffer(), 5, 2, {0, 0, 20, 10});
  const io::Image image = destination.read();
  int red = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) red += image.pixel(x, y)[0] == 255;
  }
  EXPECT_EQ(red, 20 * 10);
  EXPECT_EQ(image.pixel(5, 27)[0], 255);  // lower left corner at (5, 2) from below
  EXPECT_EQ(image.pixel(24, 18)[0], 255);
}

TEST_F(RendererTest, UploadReplacesWhatWasThere) {
  Camera camera = Camera::parse("top");
  camera.frame(2, 1, 1);
  Renderer renderer;
  view::DrawList list;
  list.update(spheres({{0, 0, 1}, {1, 0, 1}}, 0.3), kJet, camera, kPoints);
  renderer.upload(list);
  renderer.picture(camera, 100, 100, 1);
  list.update(spheres({{-1, 0, 1}}, 0.3), kJet, camera, kPoints);
  renderer.upload(list);
  const io::Image image = renderer.picture(camera, 100, 100, 1);
  EXPECT_EQ(sphere_in(color_at(image, 26, 50)), 0);
  EXPECT_EQ(sphere_in(color_at(image, 50, 50)), -1);
  EXPECT_EQ(sphere_in(color_at(image, 74, 50)), -1);
}

TEST_F(RendererTest, RefusesATargetLargerThanTheDriverAllows) {
  try {
    Target().resize(1 << 20, 4);
    FAIL();
  } catch (const io::Failure& failure) {
    EXPECT_EQ(failure.code(), io::ExitCode::bad_input);
    EXPECT_NE(std::string(failure.what()).find("1048576x4"), std::string::npos);
  }
}

}  // namespace
}  // namespace pupflow::gl
