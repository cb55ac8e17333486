// The arena in its part of the window: the camera that the mouse moves, drawing, pictures.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/gl/renderer.h"
#include "app/gl/target.h"
#include "app/pictures/look.h"
#include "app/pictures/picture.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"
#include "app/window/session/session.h"

namespace pupflow::window {

/// Draws snapshots. A context must be current whenever a function here runs.
class ArenaView {
 public:
  /// Throws Failure for shaders that cannot be used.
  explicit ArenaView(const pictures::Look& look);

  /// Looks through `camera`, the arena filling the picture.
  void look_from(const view::Camera& camera) { camera_ = camera; }

  // The mouse: turns by radians, moves by shares of the picture's height, comes nearer by a factor.
  void orbit(double d_azimuth, double d_elevation) { camera_.orbit(d_azimuth, d_elevation); }
  void pan(double right, double up) { camera_.pan(right, up); }
  void zoom_at(double factor, double right, double up) { camera_.zoom_at(factor, right, up); }

  const view::Camera& camera() const { return camera_; }

  /// How bodies are drawn from now on.
  void set_look(const pictures::Look& look) { look_ = look; }

  /// The outlines of the bodies that were drawn last.
  std::span<const view::Ball> bodies() const { return list_.balls(); }

  /// Draws `snapshot` into a store of its own, `width` x `height` pixels with `samples` x `samples`
  /// samples each in the colors of `scale`, unless it is drawn there already. `fresh` says that the
  /// snapshot is another one than last time. Returns whether anything was drawn.
  bool draw(const LiveState& snapshot, bool fresh, const view::ColorScale& scale, int width,
            int height, int samples);

  /// What was drawn.
  const gl::Target& store() const { return store_; }

  /// The picture of `snapshot` that `picture` makes from here.
  io::Image picture(pictures::Picture& picture, const LiveState& snapshot);

  /// Writes the picture that `pupflow render` would make from here, in its usual size, with the
  /// color bar and all that is needed to make it again. Overwrites nothing. Throws Failure.
  void write_picture(const std::string& path, const LiveState& snapshot,
                     const pictures::Look& look);

 private:
  pictures::Look look_;  // how bodies are drawn
  gl::Renderer renderer_;
  gl::Target store_;
  view::DrawList list_;
  view::Camera camera_ = view::Camera::parse(view::Camera::kUsual);

  // What the store shows.
  view::Camera drawn_camera_;
  std::optional<view::ColorScale> drawn_scale_;
  int drawn_samples_ = 0;
};

/// Where the next picture goes: `pattern` (with %d or %05d for the step; empty: pupflow-%05d.png)
/// with the step filled in, and -2, -3 ... added before the ending until no such file exists.
/// Throws Failure(bad_input) for a bad pattern.
std::string picture_path(const std::string& pattern, std::int64_t step);

}  // namespace pupflow::window
