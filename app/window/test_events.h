// Lines on standard output for tests that work the window from outside.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "app/view/camera.h"
#include "app/window/controls.h"
#include "app/window/panels/area.h"
#include "app/window/session/session.h"

namespace pupflow::window {

/// When switched on, prints one line for each event:
///   widget NAME X Y W H in PANEL CX CY CW CH [scrolls]
///                         where a widget is (window coordinates), when it appears or moves; the
///                         panel it belongs to, the part of it that shows widgets, and whether
///                         there is more to see by scrolling
///   gone NAME             that widget cannot be seen any more
///   value NAME VALUE      a parameter as the simulation has taken it, when it changes
///   panels NAME VALUE     the panels on the screen show that value of a parameter, when it changes
///   arena NAME VALUE      and so does the arena: its litter has that value
///   problem FIELD WHY     a value was not taken; without both: that is over
///   speed FACTOR          the speed that was asked for, when it changes
///   second DIFFERENCE     what differs in the litter beside this one, or none
///   state playing|paused
///   step N                at rest after every change, else now and then
///   hash N H              at rest: the simulation's hash after step N
///   bad MESSAGE           the status, when it is bad
///   warning MESSAGE       a warning of the engine, when it is new
///   text on|off           whether a text field has the keyboard
///   title TEXT            the window's title, when it changes
///   opened SOURCE, saved PATH, copied COMMAND, refused REASON
///   help shown|hidden, camera AZIMUTH ELEVATION DISTANCE, screenshot PATH
///   selected PUP|none, view free|follow|eye
///   field NAME TEXT       a field of the selected pup as the inspector shows it, when it changes
///   mark TEXT|none        what the mouse points at on the timeline, when it changes
///   samples N             the arena has N x N samples a pixel, when N changes
///   plots-span SPAN, plots-smooth TIME  what was chosen for the plots
///   pointed TIME|nowhere  where on the plots' common time axis the mouse is
///   tip X Y W H, tip none  where the tooltip is
///   theme light|dark, filmed PATH
///   visible yes|no        the window was minimised or shown again
///   frames N              the window is closed after drawing N frames
class TestEvents {
 public:
  explicit TestEvents(bool on) : on_(on) {}
  bool on() const { return on_; }

  /// The Dear ImGui item just submitted, if any of it can be seen.
  void widget(std::string_view name);

  /// A part of the window that is no Dear ImGui item: a widget in a panel of its own.
  void area(std::string_view name, const Area& place);

  void snapshot(const LiveState& snapshot);
  /// Why the last value typed was not taken, when that changes.
  void problem(const std::string& field, const std::string& text);
  void help(bool shown);
  void tip(const std::optional<Area>& shown);
  void visible(bool is) const;
  void text(bool has_keyboard);
  void camera(const view::Camera& camera);
  void selected(std::optional<int> pup, CameraMode mode);

  /// What the inspector shows in one of its rows.
  void field(std::string_view name, const std::string& text);
  void screenshot(const std::string& path);
  /// The line "KIND TEXT", when the text changes.
  void note(const std::string& kind, const std::string& text);
  /// What a frame that is on the screen shows: the parameters of the panels, and of the litter.
  void shown(const Params& panels, const Params& arena);

  /// A frame is on the screen, its arena with so many samples; 0: without an arena.
  void frame(int samples);
  void closed() const;

 private:
  using Clock = std::chrono::steady_clock;

  void say(const std::string& line) const;
  void widget_line(std::string_view name, const std::string& line);
  void forget_widgets();
  void say_changes(const char* kind, std::optional<Params>& said, const Params& now) const;

  bool on_;
  struct Widget {
    std::string said;   // its last line
    bool seen = false;  // in the frame being made
  };
  std::string tip_ = "tip none";
  std::map<std::string, Widget> widgets_;
  std::map<std::string, std::string> notes_;
  std::optional<Params> params_, panels_, arena_;
  std::string problem_, second_ = "none";
  double speed_ = 1;
  std::optional<bool> playing_, help_, text_;
  std::optional<view::Camera> camera_;
  std::optional<int> selected_;
  CameraMode mode_ = CameraMode::free;
  std::map<std::string, std::string, std::less<>> fields_;
  std::int64_t step_ = -1;
  std::optional<std::uint64_t> hash_;
  Clock::time_point step_said_{};
  bool bad_ = false;
  std::size_t warnings_ = 0;
  int frames_ = 0, samples_ = 0;
};

}  // namespace pupflow::window
