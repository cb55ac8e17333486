#include "app/window/arena_view.h"

#include <utility>

#include "app/view/framing.h"

namespace pupflow::window {
namespace {

constexpr double kForever = 3600;  // seconds

}  // namespace

ArenaView::ArenaView(const pictures::Look& look, std::function<void()> notify)
    : look_(look), renderer_(look.shader_dir), worker_(std::move(notify)) {}

bool ArenaView::Wanted::same_as(const Wanted& other) const {
  return camera == other.camera && scale.same_as(other.scale) &&
         drawing.rows == other.drawing.rows && drawing.draw == other.drawing.draw &&
         drawing.quality == other.drawing.quality;
}

bool ArenaView::draw(const LitterView& litter, bool fresh, const view::ColorScale& scale, int width,
                     int height, int samples) {
  camera_ = view::framed(camera_, litter.params, static_cast<double>(width) / height);
  const Wanted wanted{
      camera_, scale, {.draw = look_.draw, .quality = look_.quality, .rows = height * samples}};
  const bool new_size = store_.width() != width || store_.height() != height;
  bool anew = pending_ && finish(new_size || fresh ? kForever : 0);
  if (!pending_ && (fresh || !begun_ || !wanted.same_as(wanted_))) {
    begun_ = pending_ = true;
    wanted_ = wanted;
    worker_.start(
        [this, litter] { next_.update(litter, wanted_.scale, wanted_.camera, wanted_.drawing); });
    anew |= finish(new_size ? kForever : kPatience);
  }
  if (!anew && !new_size && samples == drawn_samples_) return false;
  if (!uploaded_) renderer_.upload(list_);
  uploaded_ = true;
  store_.resize(width, height);
  store_.bind();
  renderer_.draw(drawn_.camera, {0, 0, width, height}, samples);
  drawn_samples_ = samples;
  return true;
}

/// Takes over what is pending when it is done within `patience` seconds.
bool ArenaView::finish(double patience) {
  if (!worker_.done_within(patience)) return false;
  pending_ = false;
  std::swap(list_, next_);
  drawn_ = wanted_;
  uploaded_ = false;
  return true;
}

}  // namespace pupflow::window
