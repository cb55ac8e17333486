#include "app/window/live_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "app/gl/load.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/text.h"
#include "app/window/panels/overlays.h"
#include "app/window/picture_path.h"

namespace pupflow::window {
namespace {

/// Where no scene says what is seen.
constexpr const char* kWelcome =
    "Cold pups turn to warmth, and huddle. Try another T\u2090, drag the arena, click on a pup. "
    "F1: help.";

bool drawn_by_processor() {
  const std::string name = gl::renderer_name();
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos ||
         name.find("SwiftShader") != std::string::npos;
}

}  // namespace

LiveWindow::LiveWindow(const LiveJob& job, const Settings& settings)
    : job_(job),
      window_({.title = "pupflow", .width = job.width, .height = job.height}),
      covering_(window_.handle()),
      painter_(window_, drawn_by_processor()),
      arena_(window_, job.look, glfwPostEmptyEvent),
      events_(job.test_events),
      runner_({.params = job.params,
               .from = job.from,
               .playing = !job.paused,
               .threads = job.threads,
               .notify = [] { glfwPostEmptyEvent(); }}),
      schedule_(drawn_by_processor()),
      desk_({job.opened, job.params, job.from ? job.from->edited : std::nullopt}),
      settings_(settings),
      written_(settings) {
  picture_path(job.screenshot, 0);  // a bad pattern fails now, not with the first screenshot
  controls_.params = controls_.seen = controls_.scene = job.params;
  controls_.look = job.look;
  controls_.panels = settings.panels;
  controls_.pause_minimised = settings.pause_minimised;
  controls_.recent = settings.recent;
  seen_ = present();
  seen_field_ = job.look.scale.field;
  runner_.send(ColorBy{job.look.scale.field});
  install_callbacks();
  gui_ = std::make_unique<Gui>(window_, job.ui_scale, settings.theme);
  install_key_callback();
  glfwSwapInterval(1);
  if (job.look.verbose) {
    std::cerr << "OpenGL: " << window_.name() << ", " << gl::renderer_name() << ", "
              << gl::version_text() << '\n';
  }
  show(desk_.description().empty() ? kWelcome : desk_.title() + ": " + desk_.description());
}

void LiveWindow::run() {
  while (!closing() || picture_waits_) {
    wait_for_events();
    if (io::interrupted()) {
      throw io::Failure(io::ExitCode::interrupted,
                        film_ || ended_film_ ? "interrupted; no film was written" : "interrupted");
    }
    const double now = glfwGetTime();
    follow_visibility();
    const bool drawn = arena_.collect(), second_drawn = second_ && second_->view.collect();
    if (drawn || second_drawn) schedule_.panels_changed();
    // A picture is seen with the marks of its own snapshot before the next one comes.
    const bool seen_first = schedule_.visible() && (drawn || second_drawn);
    if (!seen_first) exchange_snapshots(now);
    feed_film();
    if (runner_.busy_for() > kLongStep) schedule_.panels_changed();
    if (schedule_.frame_due(now)) frame(now);
    if (seen_first) exchange_snapshots(now);  // it may have come, and been told of, before
  }
  arena_.finish();
  end_film();
  settle_ended_film(true);
  keep_settings();
  events_.closed();
}

bool LiveWindow::closing() const {
  return glfwWindowShouldClose(window_.handle()) == GLFW_TRUE ||
         (job_.exit_after > 0 && glfwGetTime() >= job_.exit_after);
}

void LiveWindow::wait_for_events() {
  const double now = glfwGetTime();
  double seconds = schedule_.sleep(now);
  if (job_.exit_after > 0) seconds = std::min(seconds, job_.exit_after - now);
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

void LiveWindow::follow_visibility() {
  const bool shown = glfwGetWindowAttrib(window_.handle(), GLFW_VISIBLE) == GLFW_TRUE &&
                     glfwGetWindowAttrib(window_.handle(), GLFW_ICONIFIED) == GLFW_FALSE;
  if (suspended_ != (!shown && controls_.pause_minimised)) {
    suspended_ = !suspended_;
    runner_.send(Suspend{suspended_});
  }
  const bool visible = shown && !covering_.whole();
  if (visible == schedule_.visible()) return;
  schedule_.set_visible(visible);
  events_.visible(visible);
}

void LiveWindow::exchange_snapshots(double now) {
  const bool pending = arena_.pending() || (second_ && second_->view.pending());
  if (!pending && runner_.take()) {
    const LiveState& snapshot = runner_.snapshot();
    schedule_.snapshot_arrived(now);
    events_.snapshot(snapshot);
    controls_.follow(snapshot);
    film_snapshot();
    if (std::exchange(picture_waits_, false)) take_picture();
  }
  if (!schedule_.wants_snapshot(now)) return;
  runner_.request();
  schedule_.snapshot_requested();
}

void LiveWindow::frame(double now) {
  schedule_.begin_frame(now);
  gui_->begin_frame();
  typing_ends_ = false;
  const ImGuiIO& io = ImGui::GetIO();
  const Layout layout = lay_out();
  const LiveState& snapshot = runner_.snapshot();
  const double rate = snapshot.playing ? schedule_.frames_per_second() : 0;
  const PanelInput input{snapshot, controls_, gui_->fonts(), events_, tips_, rate};
  tips_.begin_frame(layout, now);
  panels_.draw(layout, input);
  fit_scale();
  legend_.draw(layout.bar, scale_, input);
  if (schedule_.shows_message()) {
    draw_message(layout.arena, message_);
  } else if (const double busy = runner_.busy_for(); busy > kLongStep) {
    draw_message(layout.arena, io::formatted("one step or change takes long: %.0f s so far", busy));
  }
  if (gui_->clicks_wait()) schedule_.event();
  if (io.WantTextInput) schedule_.cursor_shown(now);
  if (const auto due = tips_.due()) schedule_.wake_at(*due);
  if (const double rest = std::exchange(controls_.wake_in, 0); rest > 0) {
    schedule_.wake_at(now + rest);
  }
  events_.tip(tips_.shown());
  events_.text(text_has_keyboard());
  events_.area("arena", layout.arena);
  const ArenaAreas arenas = split_arena(layout.arena, snapshot.second.has_value());
  point_at_pups(arenas);
  events_.problem(controls_.problem_at, controls_.problem);
  move_camera(at_second(arenas) ? *arenas.second : arenas.first, now);
  desk_frame(input);
  lead_camera(now);
  controls_.watch();
  const DrawnArenas drawn = draw_arenas(arenas);
  const PixelBox seen = pixels_of(
      {layout.arena.corner, {layout.arena.size.x + layout.bar.size.x, layout.arena.size.y}});
  controls_.seen_size = {seen.width(), seen.height()};
  gui_->end_frame();

  carry_out(now);
  paint(drawn);
  schedule_.end_frame();
}

Layout LiveWindow::lay_out() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  LayoutWish wish{.width = size.x, .height = size.y, .scale = gui_->scale()};
  wish.menu = ImGui::GetFrameHeight();
  wish.transport = panels_.transport_height();
  if (wish.transport == 0) wish.transport = LayoutWish{}.transport * wish.scale;
  wish.panels = controls_.panels;
  wish.drawer = controls_.drawer;
  const Layout layout = make_layout(wish);
  controls_.narrow = layout.narrow;
  return layout;
}

/// After the panels, which may have chosen another field.
void LiveWindow::fit_scale() {
  const view::ColorScale& wanted = controls_.look.scale;
  const LitterView litter = runner_.snapshot().view();
  std::vector<double> values = wanted.field->values(litter);
  if (const auto& second = runner_.snapshot().second) {
    const std::vector<double> more = wanted.field->values(second->view());
    values.insert(values.end(), more.begin(), more.end());
  }
  const view::ColorScale fitted = wanted.fitted(values, litter.params.preferred_temperature);
  const bool goes_on = fitted.follows(scale_) && litter.time >= scale_time_;
  scale_ = goes_on ? fitted.eased(scale_, view::easing(litter.time - scale_time_)) : fitted;
  scale_time_ = litter.time;
}

}  // namespace pupflow::window
