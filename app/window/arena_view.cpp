#include "app/window/arena_view.h"

#include <filesystem>
#include <utility>

#include "app/io/frame_path.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/pictures/picture.h"
#include "app/view/framing.h"

namespace pupflow::window {
namespace {

constexpr const char* kPattern = "pupflow-%05d.png";
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

io::Image ArenaView::picture(pictures::Picture& picture, const LiveState& snapshot) {
  const LitterView litter = snapshot.view();
  uploaded_ = false;  // from here on the renderer holds what this picture shows
  return picture.draw(renderer_, litter,
                      view::framed(camera_, litter.params, picture.scene_aspect()));
}

void ArenaView::write_picture(const std::string& path, const LiveState& snapshot,
                              const pictures::Look& look, const view::Trails& trails, int width,
                              int height) {
  const LitterView litter = snapshot.view();
  pictures::Picture picture(width, height, true, look);
  picture.remember(trails);
  const view::Camera camera = view::framed(camera_, litter.params, picture.scene_aspect());
  const io::Image image = this->picture(picture, snapshot);

  io::TextEntries extra{{"picture", "live"}, {"step", std::to_string(litter.step)}};
  const auto add = [&](const io::TextEntries& more) {
    extra.insert(extra.end(), more.begin(), more.end());
  };
  add(pictures::camera_entries(camera));
  add({{"size", std::to_string(width) + "x" + std::to_string(height)}});
  if (snapshot.hash) add({{"hash", io::hash_text(*snapshot.hash)}});
  add(picture.look_entries());
  io::write_png(path, image, io::provenance(litter.recipe, extra), false,
                pictures::png_options(look));
}

std::string picture_path(const std::string& pattern, std::int64_t step) {
  const std::string first = io::frame_path(pattern.empty() ? kPattern : pattern, step);
  const std::filesystem::path path(first);
  std::string candidate = first;
  for (int number = 2; std::filesystem::exists(candidate); ++number) {
    candidate = (path.parent_path() / path.stem()).string() + '-' + std::to_string(number) +
                path.extension().string();
  }
  return candidate;
}

}  // namespace pupflow::window
