#include "app/window/arena_view.h"

#include <filesystem>

#include "app/io/frame_path.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/pictures/picture.h"
#include "app/pictures/render.h"
#include "app/view/framing.h"

namespace pupflow::window {
namespace {

constexpr const char* kPattern = "pupflow-%05d.png";

}  // namespace

ArenaView::ArenaView(const pictures::Look& look) : look_(look), renderer_(look.shader_dir) {}

bool ArenaView::draw(const LiveState& snapshot, bool fresh, const view::ColorScale& scale,
                     int width, int height, int samples) {
  const LitterView litter = snapshot.view();
  camera_ = view::framed(camera_, litter.params, static_cast<double>(width) / height);
  const view::Drawing drawing{
      .draw = look_.draw, .quality = look_.quality, .rows = height * samples};
  const view::Drawing& drawn = list_.drawing();
  const bool other_bodies =
      drawing.rows != drawn.rows || drawing.draw != drawn.draw || drawing.quality != drawn.quality;
  const bool reload = fresh || other_bodies || camera_ != drawn_camera_ || !drawn_scale_ ||
                      !scale.same_as(*drawn_scale_);
  const bool same_store =
      store_.width() == width && store_.height() == height && samples == drawn_samples_;
  if (!reload && same_store) return false;
  if (reload) {
    list_.update(litter, scale, camera_, drawing);
    renderer_.upload(list_);
  }
  store_.resize(width, height);
  store_.bind();
  renderer_.draw(camera_, {0, 0, width, height}, samples);
  drawn_camera_ = camera_;
  drawn_scale_ = scale;
  drawn_samples_ = samples;
  return true;
}

io::Image ArenaView::picture(pictures::Picture& picture, const LiveState& snapshot) {
  const LitterView litter = snapshot.view();
  drawn_scale_.reset();  // from here on the renderer holds what this camera sees
  return picture.draw(renderer_, litter,
                      view::framed(camera_, litter.params, picture.scene_aspect()));
}

void ArenaView::write_picture(const std::string& path, const LiveState& snapshot,
                              const pictures::Look& look) {
  const pictures::RenderJob usual;
  const LitterView litter = snapshot.view();
  pictures::Picture picture(usual.width, usual.height, true, look);
  const view::Camera camera = view::framed(camera_, litter.params, picture.scene_aspect());
  const io::Image image = this->picture(picture, snapshot);

  io::TextEntries extra{{"picture", "live"}, {"step", std::to_string(litter.step)}};
  const auto add = [&](const io::TextEntries& more) {
    extra.insert(extra.end(), more.begin(), more.end());
  };
  add(pictures::camera_entries(camera));
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
