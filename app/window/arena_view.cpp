#include "app/window/arena_view.h"

#include <GL/glew.h>

#include <chrono>
#include <utility>

#include "app/view/framing.h"

namespace pupflow::window {
namespace {

/// What takes no longer is waited for, so that it is in the same frame as the panels; seconds.
constexpr double kQuick = 0.025;

constexpr double kForever = 3600;  // seconds

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ArenaView::ArenaView(const context::GlfwWindow& window, const pictures::Look& look,
                     std::function<void()> notify)
    : look_(look), context_(window), worker_(std::move(notify)) {
  give({.work =
            [this, shaders = look.shader_dir] {
              context_.make_current();
              drawer_.emplace(Drawer{gl::Renderer(shaders), {}});
            },
        .done = {},
        .holds = false});
}

ArenaView::~ArenaView() {
  const auto wait = [&] {
    for (bool idle = false; !idle;) {
      try {
        idle = worker_.done_within(kForever);
      } catch (...) {  // the window ends without its picture
      }
    }
  };
  wait();
  worker_.start([this] {
    drawer_.reset();
    context_.release_current();
  });
  wait();
}

bool ArenaView::Wanted::same_as(const Wanted& other) const {
  return camera == other.camera && scale.same_as(other.scale) &&
         drawing.rows == other.drawing.rows && drawing.draw == other.drawing.draw &&
         drawing.quality == other.drawing.quality && width == other.width &&
         height == other.height && samples == other.samples;
}

bool ArenaView::draw(const LitterView& litter, bool fresh, const view::ColorScale& scale, int width,
                     int height, int samples) {
  camera_ = view::framed(camera_, litter.params, static_cast<double>(width) / height);
  stale_ |= fresh;
  const Wanted wanted{
      camera_, scale,  {.draw = look_.draw, .quality = look_.quality, .rows = height * samples},
      width,   height, samples};
  if (!drawing_ && (stale_ || !wanted.same_as(wanted_))) {
    wanted_ = wanted;
    stale_ = false;
    drawing_ = true;
    give({.work = [this, litter] { draw_next(litter); },
          .done = [this] { take_drawn(); },
          .holds = true});
  }
  if (drawing_ && !anew_ && took_ <= kQuick) collect_within(kQuick);
  return std::exchange(anew_, false);
}

/// On the worker.
void ArenaView::draw_next(const LitterView& litter) {
  const double begun = seconds();
  next_.update(litter, wanted_.scale, wanted_.camera, wanted_.drawing);
  drawer_->renderer.upload(next_);
  gl::Target& store = drawer_->stores[1 - front_];
  store.resize(wanted_.width, wanted_.height);
  store.bind();
  drawer_->renderer.draw(wanted_.camera, {0, 0, wanted_.width, wanted_.height}, wanted_.samples);
  glFinish();  // another context reads it
  takes_ = seconds() - begun;
}

void ArenaView::take_drawn() {
  std::swap(list_, next_);
  drawn_ = wanted_;
  front_ = 1 - front_;
  shown_.show(drawer_->stores[front_].texture(), drawn_.width, drawn_.height);
  took_ = takes_;
  drawing_ = false;
  anew_ = true;
}

void ArenaView::start(std::function<void(gl::Renderer&)> work, std::function<void()> done) {
  give({.work = [this, work = std::move(work)] { work(drawer_->renderer); },
        .done = std::move(done),
        .holds = true});
}

void ArenaView::give(Job job) {
  if (job.holds) ++pending_;
  jobs_.push_back(std::move(job));
  if (jobs_.size() == 1) worker_.start(jobs_.front().work);
}

bool ArenaView::collect_within(double patience) {
  bool any = false;
  while (!jobs_.empty() && worker_.done_within(patience)) {
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    if (!jobs_.empty()) worker_.start(jobs_.front().work);
    if (job.holds) --pending_;
    if (job.done) job.done();
    any = true;
  }
  return any;
}

void ArenaView::finish() {
  while (!jobs_.empty()) collect_within(kForever);
}

}  // namespace pupflow::window
