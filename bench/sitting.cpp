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

Sitting::Sitting(const Params& params, int width, int height)
    : context_(headless()),
      scale_("viridis", 0, 1),
      camera_(view::framed(view::Camera::parse(view::Camera::kUsual), params,
                           static_cast<double>(width) / height)) {
  target_.resize(width, height);
}

void Sitting::list(const Simulation& simulation, const view::Drawing& drawing) {
  view::Drawing sized = drawing;
  sized.rows = target_.height();
  list_.update(simulation, scale_, camera_, sized);
}

void Sitting::draw(int supersample) {
  renderer_.upload(list_);
  target_.bind();
  renderer_.draw(camera_, {0, 0, target_.width(), target_.height()}, supersample);
  glFinish();
}

void Sitting::draw_plainly() {
  target_.bind();
  plain_.draw(list_, camera_, target_.width(), target_.height());
  glFinish();
}

}  // namespace pupflow::bench
