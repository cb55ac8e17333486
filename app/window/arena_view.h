// The arena in its part of the window: the camera that the mouse moves, drawing.
#pragma once

#include <functional>
#include <span>

#include "app/gl/renderer.h"
#include "app/gl/target.h"
#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"
#include "app/window/session/session.h"
#include "app/window/session/worker.h"

namespace pupflow::window {

/// Draws snapshots. A context must be current whenever a function here runs.
class ArenaView {
 public:
  /// `notify` is called on another thread when something can be drawn. Throws Failure for shaders
  /// that cannot be used.
  ArenaView(const pictures::Look& look, std::function<void()> notify);

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

  /// Through which it was drawn.
  const view::Camera& drawn_camera() const { return drawn_.camera; }

  /// Draws `snapshot` into a store of its own, `width` x `height` pixels with `samples` x `samples`
  /// samples each in the colors of `scale`, unless it is drawn there already. `fresh` says that the
  /// snapshot is another one than last time. Returns whether anything was drawn.
  ///
  /// What is to be drawn is worked out on another thread. This one waits for kPatience, and without
  /// end where the store has no picture of that size; when it takes longer, a later call draws it.
  /// Until then it is `pending`, and the snapshot must stay as it is.
  bool draw(const LitterView& litter, bool fresh, const view::ColorScale& scale, int width,
            int height, int samples);
  bool pending() const { return pending_; }
  /// Whether the next call draws what is pending.
  bool ready() { return pending_ && !worker_.busy(); }

  /// What was drawn.
  const gl::Target& store() const { return store_; }

  /// For pictures, which upload what they show.
  gl::Renderer& lend_renderer() {
    uploaded_ = false;
    return renderer_;
  }

 private:
  static constexpr double kPatience = 0.006;  // seconds

  /// What decides how a litter is drawn.
  struct Wanted {
    view::Camera camera;
    view::ColorScale scale;
    view::Drawing drawing;
    bool same_as(const Wanted& other) const;
  };

  bool finish(double patience);

  pictures::Look look_;  // how bodies are drawn
  gl::Renderer renderer_;
  gl::Target store_;
  view::DrawList list_, next_;  // drawn, and being worked out
  view::Camera camera_ = view::Camera::parse(view::Camera::kUsual);
  Wanted drawn_, wanted_;  // of these two
  bool pending_ = false;
  bool begun_ = false;     // something was wanted
  bool uploaded_ = false;  // the renderer holds list_
  int drawn_samples_ = 0;
  Worker worker_;  // last: it uses next_
};

}  // namespace pupflow::window
