// The window's loop: events in, commands to the runner, frames out.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/context/glfw_window.h"
#include "app/io/failure.h"
#include "app/view/pick.h"
#include "app/window/arena_marks.h"
#include "app/window/arena_view.h"
#include "app/window/controls.h"
#include "app/window/film.h"
#include "app/window/gui.h"
#include "app/window/live_job.h"
#include "app/window/painter.h"
#include "app/window/panels/dialogs.h"
#include "app/window/panels/legend_panel.h"
#include "app/window/panels/panels.h"
#include "app/window/scene_desk.h"
#include "app/window/seen_picture.h"
#include "app/window/selection.h"
#include "app/window/session/redraw_schedule.h"
#include "app/window/session/runner.h"
#include "app/window/settings.h"
#include "app/window/test_events.h"
#include "app/window/x_covering.h"

namespace pupflow::window {

/// One window with one litter, on the main thread. Sleeps until an event or a snapshot arrives, and
/// draws a frame only when the schedule says that one is due.
class LiveWindow {
 public:
  /// Opens the window. Throws Failure and InvalidParams.
  LiveWindow(const LiveJob& job, const Settings& settings);
  LiveWindow(const LiveWindow&) = delete;
  LiveWindow& operator=(const LiveWindow&) = delete;

  /// Returns when the window is closed. Throws Failure(interrupted) after Ctrl-C.
  void run();

 private:
  struct ArenaAreas {
    Area first;
    std::optional<Area> second;
  };
  struct DrawnArenas {  // in this frame
    std::vector<Painter::Image> images;
    bool anew = false;
  };
  struct FilmFrame {  // under way to the film
    io::Image image;
    std::int64_t step;
    bool bad;  // the last one: the numbers went wrong
    std::string problem;
    bool drawn;
  };
  struct SecondArena {  // while comparing
    ArenaView view;
    ArenaMarks marks;
    bool unmarked;  // the litter is another one than its marks are of
  };

  // live_window.cpp: the loop and its frames.
  bool closing() const;
  void wait_for_events();
  void follow_visibility();
  void exchange_snapshots(double now);
  void frame(double now);
  Layout lay_out();
  void fit_scale();

  // live_arena.cpp: one litter, or two beside each other.
  ArenaAreas split_arena(const Area& arena, bool two);
  DrawnArenas draw_arenas(const ArenaAreas& areas);
  PixelBox pixels_of(const Area& area) const;
  void label_arenas(const ArenaAreas& areas) const;
  void paint(const DrawnArenas& drawn);

  // live_actions.cpp: what keys, buttons and the mouse do.
  void install_callbacks();
  void install_key_callback();
  void key(int code, int mods, bool repeated);
  static bool text_has_keyboard();
  void move_camera(const Area& arena, double now);
  void carry_out(double now);
  void perform(Action action, double now);
  void close_front();
  void save_csv(StepRange steps);
  void show(const std::string& message);

  // live_picture.cpp: pictures.
  SeenPicture new_picture(const pictures::Look& look) const;
  SeenPicture::Scene scene_for(const SeenPicture& picture);
  void take_picture();

  // live_film.cpp: films.
  void switch_film();
  void film_snapshot();
  void feed_film();
  bool film_takes(Action action);
  void film_follows(const Command& command);
  void end_film();
  void drop_film();
  void settle_ended_film(bool wait);

  // live_desk.cpp: scenes, settings, closing.
  bool changed() const;
  bool edits_on_their_way() const;
  void desk_frame(const PanelInput& input);
  void desk_action(Action action);
  void ask_before(const std::string& what, std::function<void()> next);
  void wait_with(Dialogs::Answer answer);
  void carry_out_answer();
  void answer(const Dialogs::Answer& answer);
  void ask_for_name();
  bool save_as(const std::string& path);
  void open(const std::string& source);
  void refused(const io::Failure& failure);
  void take(const Opened& opened);
  void open_dropped(const std::string& path);
  void quit();
  void copy_command();
  void resize_text(int direction);
  void switch_full_screen();
  Settings present() const;
  void keep_settings();
  void show_title();

  // live_pointer.cpp: what the mouse and keys do with single pups.
  struct Pulled {  // by the mouse
    int pup;
    bool second;             // in the second arena
    Eigen::Vector3d middle;  // when the mouse took it
    Eigen::Vector3d target;  // where it is pulled to
  };
  static constexpr double kLongStep = 1;    // seconds of a step or command that the user is told of
  static constexpr float kStillPixels = 4;  // a press that moved no further is a click
  view::Ray sight_at_mouse(const Area& arena) const;
  bool at_second(const ArenaAreas& arenas) const;
  void point_at_pups(const ArenaAreas& arenas);
  void begin_pull(int pup, bool second);
  void pull(const Area& arena);
  void end_pull();
  void lead_camera(double now);
  view::Marks marks_of(const LitterView& litter, const view::Camera& camera) const;
  void perform_on_pup(Action action);

  LiveJob job_;
  context::GlfwWindow window_;  // outlives everything that lives in its context
  Covering covering_;
  Painter painter_;
  ArenaView arena_;
  ArenaMarks marks_;
  bool unmarked_ = true;  // as in the second arena
  std::unique_ptr<SecondArena> second_;
  Split split_ = Split::none;  // of the arena
  Params drawn_params_;        // of the litter that the arena shows
  std::unique_ptr<Gui> gui_;   // made after this window's own callbacks, which it then calls
  Controls controls_;
  Panels panels_;
  LegendPanel legend_;
  TestEvents events_;
  Tips tips_;
  Runner runner_;
  RedrawSchedule schedule_;
  std::unique_ptr<Film> film_, ended_film_;  // the latter is still being finished
  std::shared_ptr<FilmFrame> film_frame_;
  bool picture_waits_ = false;  // for a snapshot with its hash
  bool suspended_ = false;      // the runner: minimised, and so it was chosen
  bool film_holds_ = false;     // it takes no further steps
  SceneDesk desk_;
  Dialogs dialogs_;
  std::optional<Dialogs::Answer> waiting_;  // for edits that are on their way
  double waiting_since_ = 0;
  bool typing_ends_ = false;     // Enter came since the last frame: what follows is no text
  std::function<void()> next_;   // once the changes are saved or discarded; empty: nothing
  Settings settings_, written_;  // to keep, and as the file has them
  Settings seen_;                // the window as it was when they were last looked at
  const LitterField* seen_field_ = nullptr;
  bool settings_fail_ = false;  // it was said
  std::string title_;
  Area windowed_;  // where the window was before it was full screen
  CameraGuide guide_;
  bool pressed_arena_ = false;  // the left button went down over it, for a click or to turn it
  std::optional<Pulled> pulled_;
  std::string message_;
  view::ColorScale scale_;  // the look's, fitted to the snapshot that is shown
  double scale_time_ = 0;   // model seconds of the snapshot that it was fitted to
};

}  // namespace pupflow::window
