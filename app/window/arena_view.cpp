#include "app/window/arena_view.h"

#include <filesystem>
#include <numbers>

#include "app/io/frame_path.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/pictures/frame.h"
#include "app/pictures/studio.h"

namespace pupflow::window {
namespace {

constexpr const char* kPattern = "pupflow-%05d.png";

std::string degrees(double radians) {
  return io::number_text(radians * 180 / std::numbers::pi);
}

std::string orbit_spec(const view::Camera& camera) {
  return "orbit:" + degrees(camera.azimuth()) + ',' + degrees(camera.elevation()) + ',' +
         io::number_text(camera.distance());
}

/// How a camera that was moved by hand is written down; `start` is what it was before.
io::TextEntries moved_camera(const view::Camera& camera, const std::string& start) {
  const bool flat = camera.projection() == view::Camera::Projection::orthographic;
  const Eigen::Vector3d& target = camera.target();
  return {{"camera", flat ? start : orbit_spec(camera)},
          {"camera_target", io::number_text(target.x()) + ',' + io::number_text(target.y()) + ',' +
                                io::number_text(target.z())}};
}

}  // namespace

ArenaView::ArenaView(const pictures::Look& look)
    : renderer_(look.shader_dir), camera_(view::Camera::parse(spec_)) {}

void ArenaView::look_from(const std::string& spec) {
  camera_ = view::Camera::parse(spec);
  spec_ = spec;
  moved_ = false;
}

void ArenaView::orbit(double d_azimuth, double d_elevation) {
  if (camera_.projection() == view::Camera::Projection::orthographic) {
    const view::Camera flat = camera_;
    camera_ = view::Camera::parse(orbit_spec(flat));
    const double size = 2 * camera_.half_height();
    camera_.pan(-flat.target().dot(camera_.right()) / size,
                -flat.target().dot(camera_.up()) / size);
  }
  camera_.orbit(d_azimuth, d_elevation);
  moved_ = true;
}

void ArenaView::pan(double right, double up) {
  camera_.pan(right, up);
  moved_ = true;
}

void ArenaView::zoom(double factor) {
  camera_.zoom(factor);
  moved_ = true;
}

view::Camera ArenaView::framed(const LiveState& snapshot, double aspect) const {
  return moved_ ? camera_ : pictures::framed_camera(spec_, snapshot.view().params, aspect);
}

void ArenaView::load(const LiveState& snapshot, const pictures::Look& look,
                     const view::Camera& camera) {
  const view::ColorScale scale(look.colormap, look.scale_min, look.scale_max);
  list_.update(snapshot.view(), scale, camera);
  renderer_.upload(list_);
}

bool ArenaView::draw(const LiveState& snapshot, bool fresh, const pictures::Look& look, int width,
                     int height, int samples) {
  camera_ = framed(snapshot, static_cast<double>(width) / height);
  const bool reload = fresh || camera_ != drawn_camera_ || look.colormap != drawn_map_;
  const bool same_store =
      store_.width() == width && store_.height() == height && samples == drawn_samples_;
  if (!reload && same_store) return false;
  if (reload) load(snapshot, look, camera_);
  store_.resize(width, height);
  store_.bind();
  renderer_.draw(camera_, {0, 0, width, height}, samples);
  drawn_camera_ = camera_;
  drawn_map_ = look.colormap;
  drawn_samples_ = samples;
  return true;
}

void ArenaView::write_picture(const std::string& path, const LiveState& snapshot,
                              const pictures::Look& look) {
  const pictures::RenderJob usual;
  pictures::Frame frame(usual.width, usual.height, true);
  const view::Camera camera = framed(snapshot, frame.scene_aspect());
  load(snapshot, look, camera);
  drawn_map_.clear();  // the renderer now holds what this camera sees
  io::Image scene =
      renderer_.picture(camera, frame.scene_width(), frame.height(), look.supersample);
  const view::ColorScale scale(look.colormap, look.scale_min, look.scale_max);
  const io::Image picture =
      frame.compose(std::move(scene), scale, snapshot.view().params.preferred_temperature);

  io::TextEntries extra{{"picture", "live"}, {"step", std::to_string(snapshot.view().step)}};
  const io::TextEntries where =
      moved_ ? moved_camera(camera, spec_) : io::TextEntries{{"camera", spec_}};
  extra.insert(extra.end(), where.begin(), where.end());
  if (snapshot.edited_at > 0) {
    extra.emplace_back("edited", "parameters were changed on the way, last after step " +
                                     std::to_string(snapshot.edited_at));
  }
  const io::TextEntries looks = pictures::look_entries(look);
  extra.insert(extra.end(), looks.begin(), looks.end());
  io::write_png(path, picture, io::provenance(snapshot.view().params, extra), false);
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
