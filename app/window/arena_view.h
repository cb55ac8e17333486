// The arena in its part of the window: the camera that the mouse moves, drawing.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <span>

#include "app/context/glfw_window.h"
#include "app/gl/renderer.h"
#include "app/gl/target.h"
#include "app/pictures/look.h"
#include "app/view/camera.h"
#include "app/view/draw_list.h"
#include "app/window/session/session.h"
#include "app/window/session/worker.h"

namespace pupflow::window {

/// Draws snapshots on a thread of its own, in a second context of the window. The window's own must be
/// current whenever a function here runs. A snapshot must stay as it is while it is `pending`.
class ArenaView {
 public:
  /// `notify` is called on another thread when there is something to `collect`. Throws
  /// Failure(no_context).
  ArenaView(const context::GlfwWindow& window, const pictures::Look& look,
            std::function<void()> notify);
  /// Waits for what is under way, and leaves out what stands behind it: see `finish`.
  ~ArenaView();
  ArenaView(const ArenaView&) = delete;
  ArenaView& operator=(const ArenaView&) = delete;

  /// Looks through `camera`, the arena filling the picture.
  void look_from(const view::Camera& camera) { camera_ = camera; }

  // The mouse: turns by radians, moves by shares of the picture's height, comes nearer by a factor.
  void orbit(double d_azimuth, double d_elevation) { camera_.orbit(d_azimuth, d_elevation); }
  void pan(double right, double up) { camera_.pan(right, up); }
  void zoom_at(double factor, double right, double up) { camera_.zoom_at(factor, right, up); }

  const view::Camera& camera() const { return camera_; }

  /// How bodies are drawn from now on.
  void set_look(const pictures::Look& look) { look_ = look; }

  /// Has `litter` drawn, `width` x `height` pixels with `samples` x `samples` samples each in the
  /// colors of `scale`, unless it is drawn so already. `fresh` says that the litter is another one
  /// than last time. What was drawn quickly last time is waited for; otherwise `collect` brings it.
  /// Returns whether `shown` is another picture than at the last call.
  bool draw(const LitterView& litter, bool fresh, const view::ColorScale& scale, int width,
            int height, int samples);

  /// Has `work` done behind what is under way, where the renderer may be used; then `collect` calls
  /// `done`. `work` must throw nothing that the window is to survive.
  void start(std::function<void(gl::Renderer&)> work, std::function<void()> done);

  /// Takes over what is finished; true when there was something. Throws what drawing threw: Failure for
  /// shaders that cannot be used.
  bool collect() { return collect_within(0); }
  /// Returns when nothing is under way any more.
  void finish();

  /// Whether snapshots are in use.
  bool pending() const { return pending_ > 0; }
  /// Whether `shown` is still to become what was asked for last.
  bool drawing() const { return drawing_; }

  // What was drawn last: the picture, empty before the first one, and what it shows.
  const gl::SharedPicture& shown() const { return shown_; }
  std::span<const view::Ball> bodies() const { return list_.balls(); }  // their outlines
  const view::Camera& drawn_camera() const { return drawn_.camera; }
  int drawn_samples() const { return drawn_.samples; }

 private:
  /// What decides how a litter is drawn.
  struct Wanted {
    view::Camera camera;
    view::ColorScale scale;
    view::Drawing drawing;
    int width = 0, height = 0, samples = 0;
    bool same_as(const Wanted& other) const;
  };
  /// What lives in the context of the thread that draws.
  struct Drawer {
    gl::Renderer renderer;
    std::array<gl::Target, 2> stores;  // shown, and being drawn
  };
  struct Job {
    std::function<void()> work, done;
    bool holds;  // the snapshot
  };

  void give(Job job);
  bool collect_within(double patience);
  void draw_next(const LitterView& litter);
  void take_drawn();

  pictures::Look look_;  // how bodies are drawn
  context::SharedContext context_;
  std::optional<Drawer> drawer_;  // of the worker
  gl::SharedPicture shown_;
  std::size_t front_ = 0;       // of the stores, the one that is shown
  view::DrawList list_, next_;  // drawn, and being drawn
  view::Camera camera_ = view::Camera::parse(view::Camera::kUsual);
  Wanted drawn_, wanted_;  // of these two
  bool drawing_ = false;   // `next_` is under way
  bool stale_ = true;      // a litter has come since `wanted_`
  bool anew_ = false;      // `shown_` is another picture since the last `draw`
  double takes_ = 0;       // seconds that drawing `next_` took; the worker's
  double took_ = 1;        // and drawing `list_`
  int pending_ = 0;
  std::deque<Job> jobs_;  // the first one is under way
  Worker worker_;         // last: it uses the others
};

}  // namespace pupflow::window
