// A litter under the window's commands: what happens between and in its steps, without threads and
// clocks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/window/session/edit_log.h"
#include "app/window/session/history.h"
#include "app/window/session/litter.h"
#include "app/window/session/timeline.h"
#include "pupflow/fields.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"

namespace pupflow::window {

// What the window may ask for. Each is carried out between two steps.
struct PlayPause {};
struct Advance {  // pause, then so many steps without regard to speed
  std::int64_t steps;
};
struct Speed {  // times real time; infinite: as fast as possible
  double factor;
};
struct Edit {  // a whole parameter set; a new litter when one that defines it differs
  Params params;
  std::optional<Params> before =
      {};                  // what the user saw: only what differs from it is changed, so that
                           // the schedule goes on with the rest
  bool continues = false;  // the same drag of a slider goes on: one undo takes all of it back
};
struct Restart {};  // the same litter from t = 0
struct Open {       // another recipe, from the start or as that snapshot of it is
  Params params;
  std::optional<Snapshot> from;
};
struct ColorBy {  // the field of a pup or an afferent that is shown as color
  const LitterField* field;
};
struct Watch {  // what a step must record beside: for overlays, inspector, plots
  PartSet parts;
  bool velocities = false;
};
struct Suspend {  // no steps until further notice
  bool on;
};
struct GoTo {  // pause at that step of the run, in exactly the state that it had
  std::int64_t step;
  std::int64_t number = 0;  // LiveState says which was carried out last
};
struct SwapFuture {};  // go back to the future that an edit in the past left behind; and back again
struct RampTo {        // change a parameter of Effect::next_step evenly from now on
  std::size_t parameter;  // its place in parameters()
  double value;
  std::int64_t steps;
  bool back = false;  // and in as many steps to where it came from
};
struct Undo {};  // of edits and ramps
struct Redo {};
struct Pull {  // a spring draws that pup's centre to `target`; nobody: let go
  std::optional<int> pup;
  std::array<double, 3> target{};  // arena units
};
struct Compare {               // step a second litter beside this one; none: only one
  std::optional<Params> with;  // what differs from the present parameters differs in it
  bool from_now = false;       // it begins as this litter is now; otherwise both begin anew
};
struct Hash {};  // the next LiveState holds the hash; those at rest do anyway
using Command = std::variant<PlayPause, Advance, Speed, Edit, Restart, Open, ColorBy, Watch,
                             Suspend, GoTo, SwapFuture, RampTo, Undo, Redo, Pull, Compare, Hash>;

/// One litter as the window shows it.
struct LitterState {
  LitterCopy litter;
  LitterView view() const { return litter.view(); }
  std::optional<Observables> observables;  // of the last step, if it could be compared
  History history;
  Status status;
  std::vector<Warning> warnings;
};

/// What the window shows: the litter, or two beside each other, and how they are being stepped.
struct LiveState : LitterState {
  Timeline timeline;
  std::optional<LitterState> second;        // while comparing
  std::optional<std::int64_t> diverged_at;  // the step at which the two were seen to part
  bool playing = false;
  double speed = 1;                   // as asked for
  double steps_per_second = 0;        // as measured; 0 while at rest
  double microseconds_per_step = 0;   // as measured
  std::string rejected;               // why the last edit was not taken; empty when it was
  std::int64_t refusals = 0;          // edits and openings that were not taken, of all so far
  std::int64_t gone_to = 0;           // the number of the last GoTo
  std::optional<std::uint64_t> hash;  // of the first litter: at rest, and after Hash
};

/// Carries out commands on a litter, or on two that are stepped beside each other. Not thread-safe.
///
/// A litter goes to another step of its run by steps, like those of playing (`seeking`). A command
/// that has to do with the step that is gone to waits until it is reached; a newer GoTo takes the
/// place of the one before.
class Session {
 public:
  /// For keyframes, of all runs together.
  static constexpr std::size_t kKeyframeBytes = std::size_t{256} << 20;
  /// A recipe with so many changes takes no further pull: 5 minutes of pulling. As a scene file it
  /// is within the 1 MiB that can be opened.
  static constexpr std::size_t kMostPulls = 10'000;

  /// A new litter, or with `from` the litter of that snapshot, whose recipe is then `params`. Throws
  /// InvalidParams.
  Session(const Params& params, bool playing, int threads = 1, std::optional<Snapshot> from = {});

  void apply(const Command& command);

  /// Whether a step is wanted: now, whatever the clock says (`hurried`), or as the speed says.
  bool hurried() const { return !suspended_ && (pending_ > 0 || seeking()); }
  bool running() const { return !suspended_ && playing_; }
  double speed() const { return speed_; }
  const Params& params() const { return first_.params(); }

  /// Takes one step. A bad status ends playing.
  void step();

  /// Whether there is something new to show since the last `fill`: not on the way to another step.
  bool changed() const { return changed_ && !seeking(); }

  /// Writes the state into `state` (what is measured by the clock is left as it is).
  void fill(LiveState& state);

 private:
  /// How a litter begins: its recipe, and the snapshot that holds for, if any.
  struct Begin {
    Params recipe;
    std::shared_ptr<const Snapshot> from;
  };

  // session.cpp: commands and steps.
  void carry_out(const Command& command);
  bool rests() const { return !playing_ && pending_ == 0 && !seeking(); }
  bool seeking() const { return first_.seeking() || (second_ && second_->seeking()); }
  bool ok() const { return first_.ok() && (!second_ || second_->ok()); }
  std::vector<Litter*> litters();
  void record();
  void open(const Open& asked);
  void stop();
  void go_to(std::int64_t step);
  void arrived();
  void swap_futures();
  void see_parting();
  void fill_litter(const Litter& litter, LitterState& state) const;

  // session_changes.cpp: what changes the run.
  bool back_from_bad(const Command& command);
  bool differs(std::size_t parameter) const;
  std::vector<Setting> settings_of(std::span<const Edited> values, const Litter& litter) const;
  void edit(const Edit& asked);
  bool take(std::span<const Edited> values);
  bool restart_with(std::span<const Edited> values);
  void restart();
  template <class BeginOf>
  bool begin_anew(const BeginOf& begin);
  void ramp(const RampTo& asked);
  bool begin_ramp(const RampTo& asked);
  void undo();
  void redo();
  void mark_edit(const std::vector<Edited>& values, bool joins);
  void mark_undone(const std::vector<Edited>& values);
  void compare(const Compare& asked);
  bool put_beside(std::span<const Setting> different, bool from_now);
  void compare_other_future();

  // session_pulls.cpp
  void pull(const Pull& asked);
  void let_go();
  void hold();
  void mark_pull();

  Litter first_;
  std::optional<Litter> second_;
  std::vector<std::size_t> differing_;  // the parameters in which the two are to differ
  EditLog log_;
  std::optional<Pull> pull_;
  std::int64_t held_until_ = 0;  // the force that was recorded last
  bool pull_marked_ = false;
  const LitterField* color_by_ = &pup_fields().front();
  Watch watch_{};
  int threads_;  // that share a step
  bool suspended_ = false, playing_, changed_ = true, hash_wanted_ = false;
  bool interrupted_ = false;  // it was playing when the numbers went wrong
  std::int64_t pending_ = 0;  // steps still to be made by Advance
  double speed_ = 1;
  std::string rejected_;
  std::int64_t refusals_ = 0, gone_to_ = 0;
  std::deque<Command> waiting_;  // for the step that is gone to
};

}  // namespace pupflow::window
