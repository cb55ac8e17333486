#include "app/window/film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/window/picture_path.h"

namespace pupflow::window {
namespace {

/// What is known before the first frame: what is changed while it is filmed is not.
io::TextEntries text_of(const LitterView& start, const pictures::Look& look,
                        const view::Camera& camera, std::int64_t every) {
  io::TextEntries extra{{"picture", "movie"},
                        {"fps", std::to_string(Film::kFps)},
                        {"first_step", std::to_string(start.step)},
                        {"every", std::to_string(every)}};
  const auto add = [&](const io::TextEntries& more) {
    extra.insert(extra.end(), more.begin(), more.end());
  };
  add(pictures::camera_entries(camera));
  add(pictures::look_entries(look, look.scale.fitted({})));
  return io::provenance(start.recipe, extra);
}

std::int64_t steps_between(double speed, double dt) {
  return static_cast<std::int64_t>(std::clamp(std::round(speed / (Film::kFps * dt)), 1.0, 1e9));
}

}  // namespace

Film::Film(const std::string& path, const LitterView& start, SeenPicture picture,
           const pictures::Look& look, const view::Camera& camera, double speed,
           std::function<void()> notify)
    : path_(path),
      picture_(std::move(picture)),
      every_(steps_between(speed, start.params.dt)),
      next_(start.step),
      last_(start.step),
      thread_(std::move(notify)) {
  if (!io::has_ffmpeg()) {
    io::refuse("no film: ffmpeg is not installed (Debian and Ubuntu: apt install ffmpeg)");
  }
  movie_.emplace(path, io::MovieFile::Options{.width = picture_.size().width,
                                              .height = picture_.size().height,
                                              .fps = kFps,
                                              .text = text_of(start, look, camera, every_)});
}

void Film::add(io::Image frame, std::int64_t step) {
  frame_ = std::move(frame);
  thread_.start([this] { movie_->add(frame_); });
  last_ = step;
  next_ = step + every_;
  ++frames_;
}

void Film::finish() {
  wait();
  thread_.start([this] { movie_->finish(); });
}

void Film::wait() {
  while (!thread_.done_within(1)) continue;
}

std::string film_path(std::int64_t step) {
  return picture_path("pupflow-%05d.mp4", step);
}

}  // namespace pupflow::window
