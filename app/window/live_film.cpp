// Filming in the live window: while it films, it asks for the steps of one frame after the other.
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
    SeenPicture picture = new_picture(controls_.look);
    picture.refuse_large();
    film_ = std::make_unique<Film>(film_path(state.view().step), state.view(), std::move(picture),
                                   controls_.look, arena_.camera(), controls_.speed);
    film_holds_ = false;
    controls_.commands.push_back(Advance{0});  // pauses: from here on the film asks for the steps
    controls_.filmed = 0;
    show("filming; V ends it");
  } catch (const io::Failure& failure) {
    refused(failure);
  }
}

/// Takes the frame that has come, and asks for the steps to the next one.
void LiveWindow::film_snapshot() {
  if (!film_) return;
  const LiveState& state = runner_.snapshot();
  const std::int64_t step = state.view().step;
  const bool bad = !state.status.ok();  // the step of the next frame will not come
  if (state.playing || (!bad && !film_->due(step))) return;
  try {
    fit_scale();
    film_->add(paint_picture(film_->picture()), step);
    controls_.filmed = film_->seconds();
  } catch (const io::Failure& failure) {
    film_.reset();
    controls_.filmed.reset();
    show(failure.what());
    return;
  }
  if (bad) {
    end_film();
  } else if (!film_holds_) {
    runner_.send(Advance{film_->every()});
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

void LiveWindow::end_film() {
  if (!film_) return;
  const std::unique_ptr<Film> film = std::move(film_);
  controls_.filmed.reset();
  try {
    const std::string path = film->finish();
    events_.note("filmed", path);
    show("saved " + path + io::formatted(" (%.1f s)", film->seconds()));
  } catch (const io::Failure& failure) {
    show(failure.what());
  }
}

}  // namespace pupflow::window
