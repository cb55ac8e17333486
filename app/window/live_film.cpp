// Filming in the live window: while it films, it asks for the steps of one frame after the other. A
// frame is drawn with the arena, and written on a thread of its own; the window waits for neither.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>
#include <variant>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/window/live_window.h"

namespace pupflow::window {

void LiveWindow::switch_film() {
  if (film_) {
    end_film();
    return;
  }
  const LiveState& state = runner_.snapshot();
  try {
    settle_ended_film(true);
    SeenPicture picture = new_picture(controls_.look);
    picture.refuse_large();
    film_ = std::make_unique<Film>(film_path(state.view().step), state.view(), std::move(picture),
                                   controls_.look, arena_.camera(), controls_.speed,
                                   glfwPostEmptyEvent);
    film_holds_ = false;
    controls_.commands.push_back(Advance{0});  // pauses: from here on the film asks for the steps
    controls_.filmed = 0;
    schedule_.set_filming(true);
    show("filming; V ends it");
  } catch (const io::Failure& failure) {
    refused(failure);
  }
}

/// Has the frame of the snapshot that has come drawn.
void LiveWindow::film_snapshot() {
  if (!film_ || film_frame_) return;
  const LiveState& state = runner_.snapshot();
  if (film_->picture().litters() > 1 && !state.second) return end_film();  // it could not go on
  const std::int64_t step = state.view().step;
  const bool bad = !state.status.ok();  // the step of the next frame will not come
  if (state.playing || (!bad && !film_->due(step))) return;
  film_frame_ = std::make_shared<FilmFrame>(FilmFrame{{}, step, bad, {}, false});
  fit_scale();
  const auto draw = [frame = film_frame_, film = film_.get(),
                     scene = scene_for(film_->picture())](gl::Renderer& renderer) {
    try {
      frame->image = film->picture().draw(renderer, scene);
    } catch (const io::Failure& failure) {
      frame->problem = failure.what();
    }
  };
  arena_.start(draw, [frame = film_frame_] { frame->drawn = true; });
}

/// Gives the frame to the film once the one before is written, and asks for the steps to the next.
void LiveWindow::feed_film() {
  settle_ended_film(false);
  if (!film_ || !film_frame_ || !film_frame_->drawn) return;
  try {
    if (!film_->written()) return;
    if (!film_frame_->problem.empty()) io::refuse(film_frame_->problem);
    const auto frame = std::exchange(film_frame_, nullptr);
    film_->add(std::move(frame->image), frame->step);
    controls_.filmed = film_->seconds();
    schedule_.panels_changed();
    if (frame->bad) {
      end_film();
    } else if (!film_holds_) {
      runner_.send(Advance{film_->every()});
    }
  } catch (const io::Failure& failure) {
    drop_film();
    show(failure.what());
  }
}

/// Whether the film takes that for itself: play or pause goes on or holds.
bool LiveWindow::film_takes(Action action) {
  if (!film_ || action != Action::play_pause) return false;
  film_holds_ = !film_holds_;
  if (!film_holds_) controls_.commands.push_back(Advance{film_->every()});
  show(film_holds_ ? "the film waits" : "filming");
  return true;
}

/// Another run, or another place in it, is another film.
void LiveWindow::film_follows(const Command& command) {
  const bool leaves =
      std::holds_alternative<GoTo>(command) || std::holds_alternative<SwapFuture>(command) ||
      std::holds_alternative<Open>(command) || std::holds_alternative<Compare>(command);
  if (film_ && leaves) end_film();
}

/// With the frame that is under way. The file is finished behind the window's back.
void LiveWindow::end_film() {
  if (!film_) return;
  try {
    arena_.finish();
    if (film_frame_ && film_frame_->problem.empty()) {
      film_->wait();
      film_->add(std::move(film_frame_->image), film_frame_->step);
    }
    film_->finish();
    ended_film_ = std::move(film_);
  } catch (const io::Failure& failure) {
    show(failure.what());
  }
  drop_film();
}

void LiveWindow::drop_film() {
  film_frame_.reset();
  film_.reset();
  controls_.filmed.reset();
  schedule_.set_filming(false);
  schedule_.panels_changed();
}

/// Says where the film is once it is in its place, and waits for that if so told.
void LiveWindow::settle_ended_film(bool wait) {
  if (!ended_film_) return;
  try {
    if (wait) ended_film_->wait();
    if (!ended_film_->written()) return;
    events_.note("filmed", ended_film_->path());
    show("saved " + ended_film_->path() + io::formatted(" (%.1f s)", ended_film_->seconds()));
  } catch (const io::Failure& failure) {
    show(failure.what());
  }
  ended_film_.reset();
}

}  // namespace pupflow::window
