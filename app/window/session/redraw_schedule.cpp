#include "app/window/session/redraw_schedule.h"

#include <algorithm>

namespace pupflow::window {
namespace {

constexpr double kNewest = 0.1;  // weight of the newest interval in the running mean

}  // namespace

void RedrawSchedule::set_visible(bool visible) {
  if (visible == visible_) return;
  visible_ = visible;
  event();
}

void RedrawSchedule::snapshot_arrived(double now) {
  started_ = fresh_ = true;
  requested_ = false;
  arena_changed(now);
}

void RedrawSchedule::arena_changed(double now) {
  if (slow_gl_) sharpen_at_ = now + kRest;
}

void RedrawSchedule::panels_changed() {
  frames_wanted_ = std::max(frames_wanted_, 1);
}

void RedrawSchedule::begin_frame(double now) {
  frames_wanted_ = std::max(frames_wanted_ - 1, 0);
  if (now >= sharpen_at_) sharpen_at_ = kNever;
  if (now >= message_ends_) message_ends_ = kNever;
  wake_at_ = kNever;
  if (!fresh_) return;
  request_at_ = now + kSnapshotInterval;
  if (last_fresh_ < kNever) {
    const double seconds = now - last_fresh_;
    const bool average = frame_seconds_ > 0 && std::max(seconds, frame_seconds_) <= kGap;
    frame_seconds_ = average ? (1 - kNewest) * frame_seconds_ + kNewest * seconds : seconds;
  }
  last_fresh_ = now;
}

double RedrawSchedule::next_deadline() const {
  return std::min({sharpen_at_, message_ends_, wake_at_});
}

bool RedrawSchedule::frame_due(double now) const {
  return visible_ && started_ && (fresh_ || frames_wanted_ > 0 || now >= next_deadline());
}

bool RedrawSchedule::wants_snapshot(double now) const {
  return (visible_ || filming_) && !requested_ && now >= request_at_;
}

double RedrawSchedule::sleep(double now) const {
  if (!visible_ && !wants_snapshot(now)) return kLongestSleep;
  if (frame_due(now) || wants_snapshot(now)) return 0;
  const double next = requested_ ? next_deadline() : std::min(next_deadline(), request_at_);
  return std::min(next - now, kLongestSleep);
}

}  // namespace pupflow::window
