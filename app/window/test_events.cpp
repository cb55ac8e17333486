#include "app/window/test_events.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "app/window/session/parameter_text.h"

namespace pupflow::window {
namespace {

constexpr std::chrono::milliseconds kStepEvery{250};

int whole(float value) {
  return static_cast<int>(std::lround(value));
}

std::string box(ImVec2 corner, ImVec2 size) {
  std::string text;
  for (const float number : {corner.x, corner.y, size.x, size.y}) {
    text += ' ' + std::to_string(whole(number));
  }
  return text;
}

/// A name as one word of a line.
std::string one_word(std::string_view name) {
  std::string word(name);
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

std::string hex(std::uint64_t value) {
  io::TextStream text;
  text << std::hex << value;
  return text.str();
}

}  // namespace

void TestEvents::say(const std::string& line) const {
  std::cout << line << std::endl;  // flushed: a test waits for it
}

void TestEvents::widget(std::string_view name) {
  if (!on_ || !ImGui::IsItemVisible()) return;
  const ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 clip = list.GetClipRectMin(), clip_end = list.GetClipRectMax();
  const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
  std::string line = "widget " + one_word(name) +
                     box(ImGui::GetItemRectMin(), ImGui::GetItemRectSize()) + " in " +
                     one_word(window.Name) + box(clip, {clip_end.x - clip.x, clip_end.y - clip.y});
  if (ImGui::GetScrollMaxY() > 0) line += " scrolls";
  widget_line(name, line);
}

void TestEvents::area(std::string_view name, const Area& place) {
  if (!on_) return;
  const std::string at = box(place.corner, place.size);
  widget_line(name, "widget " + one_word(name) + at + " in " + one_word(name) + at);
}

void TestEvents::widget_line(std::string_view name, const std::string& line) {
  Widget& widget = widgets_[one_word(name)];
  widget.seen = true;
  if (widget.said == line) return;
  widget.said = line;
  say(line);
}

void TestEvents::forget_widgets() {
  for (auto place = widgets_.begin(); place != widgets_.end();) {
    const bool seen = std::exchange(place->second.seen, false);
    if (!seen) say("gone " + place->first);
    place = seen ? std::next(place) : widgets_.erase(place);
  }
}

void TestEvents::say_changes(const char* kind, std::optional<Params>& said,
                             const Params& now) const {
  for (const Parameter& parameter : parameters()) {
    if (said && parameter.get(*said) == parameter.get(now)) continue;
    say(kind + std::string(parameter.name) + ' ' + format_value(parameter, now));
  }
  said = now;
}

void TestEvents::shown(const Params& panels, const Params& arena) {
  if (!on_) return;
  say_changes("panels ", panels_, panels);
  say_changes("arena ", arena_, arena);
}

void TestEvents::snapshot(const LiveState& snapshot) {
  if (!on_) return;
  say_changes("value ", params_, snapshot.view().params);
  if (playing_ != snapshot.playing) {
    say(snapshot.playing ? "state playing" : "state paused");
    step_ = -1;  // the step at which it stopped is said after that
  }
  playing_ = snapshot.playing;
  if (speed_ != snapshot.speed) say("speed " + io::number_text(snapshot.speed));
  speed_ = snapshot.speed;
  const std::string second =
      snapshot.second ? difference_text(snapshot.view().params, snapshot.second->view().params)
                      : "none";
  if (second_ != second) say("second " + second);
  second_ = second;
  const Clock::time_point now = Clock::now();
  if (snapshot.view().step != step_ && (!snapshot.playing || now - step_said_ >= kStepEvery)) {
    say("step " + std::to_string(snapshot.view().step));
    step_ = snapshot.view().step;
    step_said_ = now;
  }
  if (!snapshot.playing && snapshot.hash && snapshot.hash != hash_) {
    say("hash " + std::to_string(snapshot.view().step) + ' ' + hex(*snapshot.hash));
    hash_ = snapshot.hash;
  }
  if (!snapshot.status.ok() && !bad_) say("bad " + snapshot.status.message());
  bad_ = !snapshot.status.ok();
  warnings_ = std::min(warnings_, snapshot.warnings.size());  // a new litter has none
  for (; warnings_ < snapshot.warnings.size(); ++warnings_) {
    say("warning " + snapshot.warnings[warnings_].message());
  }
}

void TestEvents::problem(const std::string& field, const std::string& text) {
  if (on_ && problem_ != text) say(text.empty() ? "problem" : "problem " + field + ' ' + text);
  problem_ = text;
}

void TestEvents::help(bool shown) {
  if (on_ && help_ != shown) say(shown ? "help shown" : "help hidden");
  help_ = shown;
}

void TestEvents::tip(const std::optional<Area>& shown) {
  const std::string line = shown ? "tip" + box(shown->corner, shown->size) : "tip none";
  if (on_ && line != tip_) say(line);
  tip_ = line;
}

void TestEvents::visible(bool is) const {
  if (on_) say(is ? "visible yes" : "visible no");
}

void TestEvents::text(bool has_keyboard) {
  if (on_ && text_ != has_keyboard) say(has_keyboard ? "text on" : "text off");
  text_ = has_keyboard;
}

void TestEvents::camera(const view::Camera& camera) {
  if (!on_ || camera_ == camera) return;
  camera_ = camera;
  io::TextStream line;
  line << "camera " << camera.azimuth() << ' ' << camera.elevation() << ' ' << camera.distance();
  say(line.str());
}

void TestEvents::selected(std::optional<int> pup, CameraMode mode) {
  if (on_ && selected_ != pup) say("selected " + (pup ? std::to_string(*pup) : "none"));
  constexpr std::array kModes{"free", "follow", "eye"};
  if (on_ && mode_ != mode) say(std::string("view ") + kModes[static_cast<std::size_t>(mode)]);
  selected_ = pup;
  mode_ = mode;
}

void TestEvents::field(std::string_view name, const std::string& text) {
  if (!on_) return;
  std::string& said = fields_[std::string(name)];
  if (said != text) say("field " + std::string(name) + ' ' + text);
  said = text;
}

void TestEvents::screenshot(const std::string& path) {
  if (on_) say("screenshot " + path);
}

void TestEvents::note(const std::string& kind, const std::string& text) {
  if (!on_ || notes_[kind] == text) return;
  notes_[kind] = text;
  say(kind + ' ' + text);
}

void TestEvents::frame(int samples) {
  ++frames_;
  if (on_) forget_widgets();
  if (on_ && samples != 0 && samples_ != samples) say("samples " + std::to_string(samples));
  samples_ = samples;
}

void TestEvents::closed() const {
  if (on_) say("frames " + std::to_string(frames_));
}

}  // namespace pupflow::window
