// When the live window sleeps, asks for a snapshot and draws a frame.
#pragma once

#include <algorithm>
#include <limits>

namespace pupflow::window {

/// Decides when the window draws. Owns no clock: it is told what happened, and every time is an
/// argument `now` in seconds that never decreases. With nothing to show, no frame is due.
///
/// A frame is due while the window is visible, a first snapshot has arrived, and one of these
/// holds:
/// - the last snapshot has not been drawn,
/// - Dear ImGui still wants frames after an event,
/// - a message ends,
/// - the panels change by themselves: the cursor of a text field blinks, a tooltip opens,
/// - the arena was drawn with one sample a pixel and has rested since.
class RedrawSchedule {
 public:
  /// Frames after an event. Dear ImGui needs some until its layout is final.
  static constexpr int kFramesPerEvent = 3;
  /// Seconds from drawing a snapshot to asking for the next one, at least.
  static constexpr double kSnapshotInterval = 1.0 / 60;
  /// The longest sleep in seconds; a sleeping window does not notice Ctrl-C.
  static constexpr double kLongestSleep = 0.25;
  /// Seconds between two frames while a text field shows its cursor.
  static constexpr double kCursorBlink = 0.25;
  /// Seconds of rest after which the arena is drawn with all samples.
  static constexpr double kRest = 0.2;
  /// Seconds for which a message is shown.
  static constexpr double kMessageSeconds = 4;
  /// Seconds between two frames above which their rate is not averaged with earlier ones.
  static constexpr double kGap = 0.5;

  /// `slow_gl`: the processor draws, so an arena that moves gets one sample a pixel.
  explicit RedrawSchedule(bool slow_gl) : slow_gl_(slow_gl) {}

  // What happened.

  /// An event: input, or the window system wants the window drawn.
  void event() { frames_wanted_ = kFramesPerEvent; }

  /// The window was hidden or shown. A hidden window neither draws nor asks for snapshots, unless it
  /// films.
  void set_visible(bool visible);
  void set_filming(bool filming) { filming_ = filming; }

  void snapshot_requested() { requested_ = true; }
  void snapshot_arrived(double now);

  /// A message is shown from now on; it replaces an earlier one.
  void message_shown(double now, double seconds = kMessageSeconds) {
    message_ends_ = now + seconds;
  }

  /// A frame begins. `end_frame` ends it; the three functions between them are called within it.
  void begin_frame(double now);
  /// A text field shows its cursor.
  void cursor_shown(double now) { wake_at(now + kCursorBlink); }
  /// The panels change by themselves at `time`: another frame is due then.
  void wake_at(double time) { wake_at_ = std::min(wake_at_, time); }
  /// The camera moved.
  void view_moved(double now) { arena_changed(now); }
  /// Panels that are drawn already have to be drawn again.
  void panels_changed();
  /// The frame is on the screen.
  void end_frame() { fresh_ = false; }

  // What to do.

  /// Seconds to wait for events; 0: there is something to do now.
  double sleep(double now) const;
  bool wants_snapshot(double now) const;
  bool frame_due(double now) const;

  bool visible() const { return visible_; }
  /// Whether the last snapshot has not been drawn.
  bool fresh() const { return fresh_; }
  /// The samples of the arena (n x n a pixel) in the current frame, `all` at rest.
  int samples(int all) const { return sharpen_at_ < kNever ? 1 : all; }
  /// Whether the current frame shows the message.
  bool shows_message() const { return message_ends_ < kNever; }
  /// Drawn snapshots per second, averaged over some ten of them; 0 before the second one.
  double frames_per_second() const { return frame_seconds_ > 0 ? 1 / frame_seconds_ : 0; }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  void arena_changed(double now);
  double next_deadline() const;

  bool slow_gl_;
  bool visible_ = true, filming_ = false;
  bool started_ = false;    // a snapshot has arrived
  bool fresh_ = false;      // the last one has not been drawn
  bool requested_ = false;  // the next one is on its way
  int frames_wanted_ = 0;

  // Deadlines.
  double request_at_ = 0;
  double sharpen_at_ = kNever;
  double message_ends_ = kNever;
  double wake_at_ = kNever;

  double last_fresh_ = kNever;  // when the last snapshot was drawn
  double frame_seconds_ = 0;    // mean time between two drawn snapshots
};

}  // namespace pupflow::window
