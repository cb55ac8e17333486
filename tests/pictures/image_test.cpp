#include "app/pictures/image.h"

#include <gmock/gmock.h>

#include <future>

#include "app/io/failure.h"
#include "app/pictures/picture.h"
#include "app/view/framing.h"

namespace pupflow::pictures {
namespace {

ImageJob small_job() {
  ImageJob job;
  job.width = 160;
  job.height = 120;
  return job;
}

Simulation litter() {
  Params params;
  params.pups = 3;
  Simulation simulation(params);
  simulation.run(30);
  return simulation;
}

TEST(Image, IsThePictureThatRenderDraws) {
  const Simulation simulation = litter();
  const ImageJob job = small_job();
  const io::Image drawn = image(job, simulation);
  const Headless headless(job.look);
  Picture picture(job.width, job.height, job.bar, job.look);
  const view::Camera camera = view::framed(job.camera, simulation.params(), picture.scene_aspect());
  EXPECT_EQ(drawn.rgba, picture.draw(*headless.renderer, simulation, camera).rgba);
}

TEST(Image, SeveralThreadsTakeTurns) {
  const Simulation simulation = litter();
  const io::Image expected = image(small_job(), simulation);
  std::vector<std::future<io::Image>> others;
  for (int i = 0; i < 4; ++i) {
    others.push_back(
        std::async(std::launch::async, [&] { return image(small_job(), simulation); }));
  }
  for (auto& other : others) EXPECT_EQ(other.get().rgba, expected.rgba);
}

TEST(Image, RefusesWhatCannotBeDrawnAndDrawsTheNext) {
  const Simulation simulation = litter();
  ImageJob wrong = small_job();
  wrong.width = 1;
  EXPECT_THROW(image(wrong, simulation), io::Failure);
  wrong = small_job();
  wrong.look.supersample = 99;
  EXPECT_THROW(image(wrong, simulation), io::Failure);
  EXPECT_EQ(image(small_job(), simulation).width, 160);
}

}  // namespace
}  // namespace pupflow::pictures
