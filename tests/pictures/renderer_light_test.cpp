// Light, shadows and soft edges as the renderer draws them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/pictures/color_vision.h"
#include "tests/pictures/renderer_scenes.h"

namespace pupflow::gl {
namespace {

TEST_F(RendererTest, LitTopsHaveTheColorOfTheBar) {
  Params params;
  params.pups = 1;
  params.start_spread = 0;
  const Simulation simulation(params);
  const Vector centre = simulation.view().positions.mean(0);
  Camera camera = Camera::parse("orbit:100,60,6");  // from where the lamp is
  camera.look_at(centre);
  const view::ColorScale scale;
  const Rgb bar = scale(simulation.view().tb[0]);
  for (const view::Draw draw : {view::Draw::skin, view::Draw::both, view::Draw::points}) {
    const io::Image image = take_picture(simulation, scale, camera, 401, 401, 1, {.draw = draw});
    const double radius = 0.3 / camera.half_height() * 200.5;  // pixels
    int top = 0, away = 0;
    for (int y = 0; y < 401; ++y) {
      for (int x = 0; x < 401; ++x) {
        const double r = std::hypot(x - 200, y - 200) / radius;
        if (r > std::sin(33 * kDegrees)) continue;
        ++top;
        away += test::difference(color_at(image, x, y), bar) > 3;
      }
    }
    EXPECT_GT(top, 500);
    // Between the points their spheres turn away from the eye.
    EXPECT_LE(away, draw == view::Draw::skin ? 0 : top / 3);
  }
}

TEST_F(RendererTest, LitTopsInAHuddleHaveTheColorOfTheBar) {
  Params params;
  params.ambient_temperature = 0.2;
  Simulation simulation(params);
  ASSERT_TRUE(simulation.run(800).ok());
  view::ColorScale scale("viridis", 0.2, 0.6);
  Camera camera = Camera::parse("orbit:100,60");
  camera.frame(2, 0.6, 1);
  const io::Image image = take_picture(simulation, scale, camera, 800, 800, 1, {});
  int right = 0;
  for (int pup = 0; pup < simulation.pups(); ++pup) {
    const Vector pole = simulation.view().positions.mean(pup) + 0.3 * camera.backward();
    const Vector away = pole - camera.eye();
    const double depth = -away.dot(camera.backward());
    const double pixel = 400 / (depth * std::tan(15 * kDegrees));
    const int x = static_cast<int>(400 + pixel * away.dot(camera.right()));
    const int y = static_cast<int>(400 - pixel * away.dot(camera.up()));
    const Rgb bar = scale(simulation.view().tb[static_cast<std::size_t>(pup)]);
    right += test::difference(color_at(image, x, y), bar) < 3;
  }
  EXPECT_GE(right, 8);  // of 12: others are beside or below another
}

TEST_F(RendererTest, SurfacesShowNoFishScales) {
  // Along a pup's outline from top to side the light falls off evenly.
  Params params;
  params.pups = 1;
  params.start_spread = 0;
  const Simulation simulation(params);
  Camera camera = Camera::parse("orbit:10,30,3");
  camera.look_at(simulation.view().positions.mean(0));
  const auto roughness = [&](view::Draw draw) {
    const io::Image image = take_picture(simulation, kJet, camera, 400, 400, 1, {.draw = draw});
    int sum = 0;
    for (int y = 130; y < 270; ++y) {
      const int before = image.pixel(200, y - 1)[0], now = image.pixel(200, y)[0],
                after = image.pixel(200, y + 1)[0];
      sum += std::abs(after - 2 * now + before);
    }
    return sum;
  };
  EXPECT_LT(roughness(view::Draw::skin), 60);
  EXPECT_LT(roughness(view::Draw::skin), roughness(view::Draw::points));
}

TEST_F(RendererTest, BodiesShadeTheFloorUnlessFast) {
  Params params;
  params.pups = 1;
  params.start_spread = 0;
  const Simulation simulation(params);
  const Vector centre = simulation.view().positions.mean(0);
  Camera camera = Camera::parse("top");
  camera.frame(2, 0.6, 1);
  const auto beside = [&](view::Quality quality) {
    const io::Image image =
        take_picture(simulation, kJet, camera, 400, 400, 1, {.quality = quality});
    const double unit = 200 / camera.half_height();
    const Vector place = centre - Vector(0, 0.4, 0);  // away from the lamp
    return color_at(image, static_cast<int>(200 + unit * place.x()),
                    static_cast<int>(200 - unit * place.y()));
  };
  EXPECT_LT(beside(view::Quality::normal).g, 0.9 * Palette{}.floor.g);
  EXPECT_GT(beside(view::Quality::fast).g, 0.92 * Palette{}.floor.g);
}

TEST_F(RendererTest, FromBelowTheFloorIsOpaque) {
  Params params;
  params.pups = 1;
  params.start_spread = 0;
  const Simulation simulation(params);
  Camera camera = Camera::parse("orbit:30,-50");
  camera.frame(2, 0.6, 1);
  const io::Image image = take_picture(simulation, kJet, camera, 200, 200, 1, {});
  EXPECT_EQ(color_at(image, 100, 100), Palette{}.slab);
}

double squared_error(const io::Image& a, const io::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(a.rgba[i] - b.rgba[i], 2);
  return sum / static_cast<double>(a.rgba.size());
}

TEST_F(RendererTest, SoftEdgesComeNearManySamples) {
  Params params;
  params.pups = 3;
  params.start = Start::carpet;
  const Simulation simulation(params);
  Camera camera = Camera::parse("orbit:30,35");
  camera.frame(2, 0.6, 1.25);
  for (const view::Draw draw : {view::Draw::skin, view::Draw::points}) {
    const view::Drawing drawing{.draw = draw};
    const io::Image many = take_picture(simulation, kJet, camera, 400, 320, 8, drawing);
    const io::Image one = take_picture(simulation, kJet, camera, 400, 320, 1, drawing);
    // Hard edges: every other sample of twice the size.
    const io::Image twice = take_picture(simulation, kJet, camera, 800, 640, 1, drawing);
    io::Image hard(400, 320);
    for (int y = 0; y < 320; ++y) {
      for (int x = 0; x < 400; ++x) {
        std::copy_n(twice.pixel(2 * x, 2 * y), 4, hard.pixel(x, y));
      }
    }
    EXPECT_LT(squared_error(one, many), 0.5 * squared_error(hard, many)) << name_of(draw);
  }
}

TEST_F(RendererTest, SmallBodiesAreNearerToFineSkinsThanCoarseSkinsAre) {
  Params params;
  params.pups = 100;
  params.arena_radius = 4;
  params.start = Start::carpet;
  Simulation simulation(params);
  ASSERT_TRUE(simulation.run(60).ok());
  for (const char* from : {"orbit:30,35", "top"}) {
    Camera camera = Camera::parse(from);
    camera.frame(4, 0.6, 1.25);
    const view::Drawing skins{.culling = view::Culling::none};
    const io::Image fine = take_picture(simulation, kJet, camera, 200, 160, 8, skins);
    const io::Image skin = take_picture(simulation, kJet, camera, 200, 160, 1, skins);
    const io::Image small = take_picture(simulation, kJet, camera, 200, 160, 1, {});
    EXPECT_LT(squared_error(small, fine), squared_error(skin, fine)) << from;
  }
}

TEST_F(RendererTest, SmallBodiesHideEachOtherInTheOrderOfTheirDistance) {
  Params params;
  params.pups = 2;
  params.start_spread = 0;
  Simulation simulation(params);
  for (const double front : {0.0, 1.0}) {
    for (const int pup : {0, 1}) {
      std::vector<double> cloud;
      for (int i = 0; i < simulation.points(); ++i) {
        const Vector p =
            simulation.view().positions(pup, i) - simulation.view().positions.mean(pup);
        cloud.insert(cloud.end(), {p.x() + (pup == front ? 0.35 : -0.35), p.y(), p.z() + 0.3});
      }
      simulation.set_cloud(pup, cloud, std::vector<double>(cloud.size(), 0.0));
      simulation.set_body_temperature(pup, pup);
    }
    Camera camera = Camera::parse("orbit:0,15,9");
    camera.look_at(Vector(0, 0, 0.3));
    for (const view::Quality quality : {view::Quality::fast, view::Quality::normal}) {
      const io::Image image =
          take_picture(simulation, kJet, camera, 101, 101, 1, {.quality = quality});
      const Rgb middle = color_at(image, 50, 50);
      EXPECT_EQ(middle.r > middle.b, front == 1.0) << view::name_of(quality);
    }
  }
}

TEST_F(RendererTest, WithoutPaperTheBackgroundIsTransparent) {
  Camera camera = Camera::parse("orbit:30,35");
  camera.frame(2, 0.6, 1);
  view::DrawList list;
  list.update(Simulation(Params()), kJet, camera, {.rows = 200});
  Renderer renderer;
  renderer.upload(list);
  Palette palette;
  palette.transparent = true;
  const io::Image image = renderer.picture(camera, 200, 200, 1, palette);
  EXPECT_EQ(image.pixel(1, 1)[3], 0);
  EXPECT_EQ(image.pixel(100, 110)[3], 255);
}

}  // namespace
}  // namespace pupflow::gl
