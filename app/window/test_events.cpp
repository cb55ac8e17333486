#include "app/window/test_events.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace pupflow::window {
namespace {

constexpr std::chrono::milliseconds kStepEvery{250};

int whole(float value) {
  return static_cast<int>(std::lround(value));
}

std::string hex(std::uint64_t value) {
  std::ostringstream text;
  text << std::hex << value;
  return text.str();
}

}  // namespace

void TestEvents::say(const std::string& line) const {
  std::cout << line << std::endl;  // flushed: a test waits for it
}

void TestEvents::widget(std::string_view name) {
  if (!on_ || !ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  const std::array<int, 4> box{whole(low.x), whole(low.y), whole(size.x), whole(size.y)};
  const auto [place, is_new] = widgets_.try_emplace(std::string(name), box);
  if (!is_new && place->second == box) return;
  place->second = box;
  std::string line = "widget " + std::string(name);
  for (const int number : box) line += ' ' + std::to_string(number);
  say(line);
}

void TestEvents::snapshot(const LiveState& snapshot) {
  if (!on_) return;
  for (const Parameter& parameter : parameters()) {
    if (params_ && parameter.get(*params_) == parameter.get(snapshot.view().params)) continue;
    say("value " + std::string(parameter.name) + ' ' +
        format_value(parameter, snapshot.view().params));
  }
  params_ = snapshot.view().params;
  if (playing_ != snapshot.playing) say(snapshot.playing ? "state playing" : "state paused");
  playing_ = snapshot.playing;
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

void TestEvents::help(bool shown) {
  if (on_ && help_ != shown) say(shown ? "help shown" : "help hidden");
  help_ = shown;
}

void TestEvents::text(bool has_keyboard) {
  if (on_ && text_ != has_keyboard) say(has_keyboard ? "text on" : "text off");
  text_ = has_keyboard;
}

void TestEvents::camera(const view::Camera& camera) {
  if (!on_ || camera_ == camera) return;
  camera_ = camera;
  std::ostringstream line;
  line << "camera " << camera.azimuth() << ' ' << camera.elevation() << ' ' << camera.distance();
  say(line.str());
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
  if (on_ && samples_ != samples) say("samples " + std::to_string(samples));
  samples_ = samples;
}

void TestEvents::closed() const {
  if (on_) say("frames " + std::to_string(frames_));
}

}  // namespace pupflow::window
