#include "app/window/panels/timeline_strip.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/io/text.h"
#include "app/window/panels/plot_geometry.h"
#include "app/window/panels/strip_scale.h"

namespace pupflow::window {
namespace {

constexpr float kTrack = 1.4f;    // em; below it are the other future and the text
constexpr float kHeight = 1.75f;  // em, of what can be pressed
constexpr float kReach = 0.35f;   // em; a mark is pointed at from so far

ImU32 color_of(Timeline::Kind kind) {
  switch (kind) {
    case Timeline::Kind::bad:
      return kBad;
    case Timeline::Kind::pull:
      return kPull;
    case Timeline::Kind::edit:
    case Timeline::Kind::ramp:
      break;
  }
  return kInk;
}

/// The strip's places in one frame.
struct Strip {
  StripScale scale;
  ImVec2 low, high;  // the track
  float em;
  const PanelInput& in;
  ImDrawList& list;

  float x(std::int64_t step) const { return scale.x(static_cast<double>(step)); }

  double time(double step) const {
    const LitterView litter = in.state.view();
    return litter.time + (step - static_cast<double>(litter.step)) * litter.params.dt;
  }

  void band(std::int64_t from, std::int64_t to, float top, float bottom, ImU32 color) const {
    list.AddRectFilled({x(from), top}, {std::max(x(to), x(from) + 1), bottom}, color, 0.1f * em);
  }
};

void draw_run(const Strip& strip) {
  const Timeline& run = strip.in.state.timeline;
  const float round = ImGui::GetStyle().FrameRounding;
  strip.list.AddRectFilled(strip.low, strip.high, ImGui::GetColorU32(ImGuiCol_FrameBg), round);
  strip.band(run.first, run.last, strip.low.y, strip.high.y, faded(kAccent, 0.25f));
  strip.band(run.first, strip.in.controls.shown_step(strip.in.state), strip.low.y, strip.high.y,
             faded(kAccent, 0.35f));
}

void draw_other_future(const Strip& strip) {
  const Timeline& run = strip.in.state.timeline;
  if (!run.parted_at) return;
  const float y = strip.high.y + 0.2f * strip.em, thick = 0.18f * strip.em;
  const ImU32 color = faded(kAccent, 0.45f);
  const float from = strip.x(*run.parted_at);
  strip.list.AddLine({from, strip.low.y}, {from, y}, color, 0.1f * strip.em);
  strip.list.AddRectFilled({from, y - thick / 2},
                           {std::max(strip.x(run.other_last), from + thick), y + thick / 2}, color);
}

void draw_marks(const Strip& strip) {
  for (const Timeline::Mark& mark : strip.in.state.timeline.marks) {
    const ImU32 color = color_of(mark.kind);
    const float top = strip.low.y, size = 0.26f * strip.em, x = strip.x(mark.step);
    if (mark.until) {
      strip.band(mark.step, *mark.until, top, top + 0.3f * strip.em, faded(color, 0.55f));
    } else {
      strip.list.AddTriangleFilled({x - size, top}, {x + size, top}, {x, top + 1.6f * size}, color);
    }
  }
  if (const auto parted = strip.in.state.diverged_at) {
    const float x = strip.x(*parted);
    strip.list.AddLine({x, strip.low.y}, {x, strip.high.y}, kBad, 0.12f * strip.em);
  }
}

void draw_playhead(const Strip& strip, bool held) {
  const float x = strip.x(strip.in.controls.shown_step(strip.in.state));
  const float radius = (held ? 0.42f : 0.34f) * strip.em;
  strip.list.AddLine({x, strip.low.y}, {x, strip.high.y}, kAccent, 0.14f * strip.em);
  strip.list.AddCircleFilled({x, (strip.low.y + strip.high.y) / 2}, radius, kAccent);
}

/// The mark that the mouse points at: the last one, as it is drawn above the others.
const Timeline::Mark* mark_at(const Strip& strip, float x) {
  const auto& marks = strip.in.state.timeline.marks;
  const float reach = kReach * strip.em;
  const auto found = std::find_if(marks.rbegin(), marks.rend(), [&](const Timeline::Mark& mark) {
    const float until = strip.x(mark.until.value_or(mark.step));
    return x >= strip.x(mark.step) - reach && x <= until + reach;
  });
  return found == marks.rend() ? nullptr : &*found;
}

std::string place_text(const Strip& strip, std::int64_t step) {
  return io::formatted("step %lld, %.2f s", static_cast<long long>(step),
                       strip.time(static_cast<double>(step)));
}

std::string pointed_text(const Strip& strip, float x) {
  const Timeline& run = strip.in.state.timeline;
  if (const Timeline::Mark* mark = mark_at(strip, x)) {
    std::string text = place_text(strip, mark->step);
    if (mark->until) text += " to " + place_text(strip, *mark->until);
    return text + ":  " + mark->text;
  }
  const std::int64_t step = strip.scale.step(x);
  if (step <= run.last) return place_text(strip, step) + ":  press to go there";
  if (run.parted_at && step <= run.other_last) {
    return "The future that the change at step " + std::to_string(*run.parted_at) +
           " left; \u21c4 goes back to it";
  }
  return "Not stepped yet";
}

void draw_ticks(const Strip& strip, float y) {
  constexpr int kMost = 10;
  const Fonts& fonts = strip.in.fonts;
  const float left = strip.scale.left, right = left + strip.scale.width;
  const Axis axis{{strip.time(static_cast<double>(strip.scale.first)),
                   strip.time(static_cast<double>(strip.scale.end))},
                  left,
                  right};
  const auto width = [&](const std::string& text) { return small_text_size(fonts, text + " s").x; };
  for (const Tick& tick : ticks_that_fit(axis, kMost, 2 * strip.em, width)) {
    const float x = axis.place(tick.value), extent = width(tick.text);
    strip.list.AddLine({x, strip.high.y}, {x, strip.high.y + 0.2f * strip.em}, kFaint);
    const float begin = std::clamp(x - extent / 2, left, std::max(right - extent, left));
    small_text(strip.list, fonts, {begin, y}, kFaint, tick.text + " s");
  }
}

void draw_swap(float width, const PanelInput& in) {
  const Timeline& run = in.state.timeline;
  ImGui::BeginDisabled(!run.parted_at);
  if (ImGui::Button("\u21c4", {width, 0})) in.controls.commands.push_back(SwapFuture{});
  ImGui::EndDisabled();
  in.events.widget("swap-future");
}

}  // namespace

void draw_timeline_strip(float height, const std::string& problem, const PanelInput& in) {
  const float em = ImGui::GetFontSize();
  const float button = 2 * em, gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - button - gap;
  // The ends have room for half a playhead.
  const float inset = 0.45f * em;
  const Strip strip{strip_scale(in.state.timeline, corner.x + inset, width - 2 * inset),
                    corner,
                    {corner.x + width, corner.y + kTrack * em},
                    em,
                    in,
                    *ImGui::GetWindowDrawList()};
  const float cursor_y = ImGui::GetCursorPosY();
  ImGui::InvisibleButton("timeline", {width, kHeight * em});
  in.events.widget("timeline");
  const bool held = ImGui::IsItemActive(), pointed = ImGui::IsItemHovered();
  const float mouse = ImGui::GetIO().MousePos.x;
  if (held) {
    const std::int64_t step = std::min(strip.scale.step(mouse), in.state.timeline.last);
    if (step != in.controls.shown_step(in.state)) in.controls.go_to(step, in.state.timeline);
  }
  const Timeline::Mark* const mark = pointed && !held ? mark_at(strip, mouse) : nullptr;
  in.events.note("mark", mark == nullptr ? "none" : pointed_text(strip, mouse));
  draw_run(strip);
  draw_other_future(strip);
  draw_marks(strip);
  draw_playhead(strip, held);
  const float text_y = strip.high.y + 0.36f * em;
  if (!problem.empty()) {
    strip.list.AddText({corner.x, text_y}, kBad, problem.c_str());
  } else if (pointed || held) {
    draw_rich_text(strip.list, in.fonts, {corner.x, text_y}, kInk, pointed_text(strip, mouse));
  } else {
    draw_ticks(strip, text_y);
  }
  ImGui::SameLine(0, gap);
  draw_swap(button, in);
  ImGui::SetCursorPosY(cursor_y + height);
}

}  // namespace pupflow::window
