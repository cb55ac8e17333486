// A film of the arena, frame by frame as the window shows it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/io/movie.h"
#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/window/seen_picture.h"
#include "app/window/session/worker.h"

namespace pupflow::window {

/// Writes frames, all of the size of `picture`, to an MP4 file. It says which step the next frame is of:
/// whoever steps the litter stops there until the frame is taken, so that none is left out.
class Film {
 public:
  static constexpr int kFps = 25;

  /// Begins with the litter as `start` shows it. `picture` paints the frames. `speed`: seconds of the model in a second of the
  /// film. `notify` is called on another thread whenever a frame is written. Throws Failure: bad_input
  /// without ffmpeg, with what to install; bad_file.
  Film(const std::string& path, const LitterView& start, SeenPicture picture,
       const pictures::Look& look, const view::Camera& camera, double speed,
       std::function<void()> notify);

  /// Paints its frames.
  SeenPicture& picture() { return picture_; }

  /// Steps from one frame to the next, and that of the next frame.
  std::int64_t every() const { return every_; }
  std::int64_t next() const { return next_; }

  /// Whether a litter at rest after `step` is due: it has come so far, or was taken back.
  bool due(std::int64_t step) const { return step >= next_ || step < last_; }

  /// Takes the frame after `step`; the one before must be written.
  void add(io::Image frame, std::int64_t step);

  /// Whether all that was taken is written. Throws Failure when it cannot be.
  bool written() { return thread_.done_within(0); }

  int frames() const { return frames_; }
  double seconds() const { return static_cast<double>(frames_) / kFps; }

  /// Ends it. When it is `written`, the film is in its place. Waits for the last frame. Throws Failure.
  void finish();
  const std::string& path() const { return path_; }

  /// Returns when all is written. Throws Failure.
  void wait();

 private:
  std::string path_;
  SeenPicture picture_;
  std::int64_t every_, next_, last_;
  int frames_ = 0;
  io::Image frame_;
  std::optional<io::MovieFile> movie_;
  Worker thread_;  // last: it uses the others
};

/// Where the next film goes: pupflow-STEP.mp4, with -2, -3 ... where that is taken.
std::string film_path(std::int64_t step);

}  // namespace pupflow::window
