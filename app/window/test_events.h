// Lines on standard output for tests that work the window from outside.
#pragma once

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "app/view/camera.h"
#include "app/window/session/session.h"

namespace pupflow::window {

/// When switched on, prints one line for each event:
///   widget NAME X Y W H   where a widget is (window coordinates), when it appears or moves
///   value NAME VALUE      a parameter as the simulation has taken it, when it changes
///   state playing|paused
///   step N                at rest after every change, else now and then
///   hash N H              at rest: the simulation's hash after step N
///   bad MESSAGE           the status, when it is bad
///   warning MESSAGE       a warning of the engine, when it is new
///   text on|off           whether a text field has the keyboard
///   help shown|hidden, camera AZIMUTH ELEVATION DISTANCE, screenshot PATH
///   samples N             the arena has N x N samples a pixel, when N changes
///   plots-span SPAN, plots-smooth TIME  what was chosen for the plots
///   pointed TIME|nowhere  where on the plots' common time axis the mouse is
///   saved PATH            a file was written
///   frames N              the window is closed after drawing N frames
class TestEvents {
 public:
  explicit TestEvents(bool on) : on_(on) {}
  bool on() const { return on_; }

  /// The Dear ImGui item just submitted, if any of it can be seen.
  void widget(std::string_view name);

  void snapshot(const LiveState& snapshot);
  void help(bool shown);
  void text(bool has_keyboard);
  void camera(const view::Camera& camera);
  void screenshot(const std::string& path);
  /// The line "KIND TEXT", when the text changes.
  void note(const std::string& kind, const std::string& text);
  void frame(int samples);
  void closed() const;

 private:
  using Clock = std::chrono::steady_clock;

  void say(const std::string& line) const;

  bool on_;
  std::map<std::string, std::array<int, 4>, std::less<>> widgets_;
  std::map<std::string, std::string> notes_;
  std::optional<Params> params_;
  std::optional<bool> playing_, help_, text_;
  std::optional<view::Camera> camera_;
  std::int64_t step_ = -1;
  std::optional<std::uint64_t> hash_;
  Clock::time_point step_said_{};
  bool bad_ = false;
  std::size_t warnings_ = 0;
  int frames_ = 0, samples_ = 0;
};

}  // namespace pupflow::window
