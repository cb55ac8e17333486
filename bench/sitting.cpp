#include "bench/sitting.h"

#include "app/context/headless.h"
#include "app/view/framing.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

std::unique_ptr<context::Context> headless() {
  context::ContextReport report;
  return context::make_headless(report);
}

}  // namespace

Sitting::Sitting()
    : context_(headless()),
      scale_("viridis", 0, 1),
      camera_(view::framed(view::Camera::parse(view::Camera::kUsual), huddling(Precision::float_),
                           static_cast<double>(kPictureWidth) / kPictureHeight)) {
  target_.resize(kPictureWidth, kPictureHeight);
}

void Sitting::list(const Simulation& simulation, const view::Drawing& drawing) {
  list_.update(simulation, scale_, camera_, drawing);
}

void Sitting::draw(int supersample) {
  renderer_.upload(list_);
  target_.bind();
  renderer_.draw(camera_, {0, 0, kPictureWidth, kPictureHeight}, supersample);
  glFinish();
}

void Sitting::draw_plainly() {
  target_.bind();
  plain_.draw(list_, camera_, kPictureWidth, kPictureHeight);
  glFinish();
}

}  // namespace pupflow::bench
