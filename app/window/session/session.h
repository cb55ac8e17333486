// One litter under the window's commands: what happens between and in its steps, without threads
// and clocks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/window/session/history.h"
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
struct Observe {    // whether the observables are shown
  bool on;
};
struct ColorBy {  // the field of a pup or an afferent that is shown as color
  const LitterField* field;
};
struct Watch {  // what a step must record beside: for overlays, inspector, plots
  PartSet parts;
  bool velocities = false;
};
struct Suspend {  // the window is hidden: no steps until further notice
  bool on;
};
struct GoTo {  // pause at that step of the run, in exactly the state that it had
  std::int64_t step;
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
using Command = std::variant<PlayPause, Advance, Speed, Edit, Restart, Observe, ColorBy, Watch,
                             Suspend, GoTo, SwapFuture, RampTo, Undo, Redo, Pull, Compare>;

/// A run so far, which can be gone back to.
struct Timeline {
  enum class Kind { edit, ramp, pull, bad };
  struct Mark {
    std::int64_t step;
    std::optional<std::int64_t> until;  // of ramps
    Kind kind;
    std::string text;  // what was done, as people read it: "T_a 0.4 \u2192 0.2"
  };

  std::int64_t first = 0, last = 0;  // the steps that can be gone to
  std::vector<Mark> marks;           // by step
  // The future that was left for an edit in the past: where it parts from this run, and its end.
  std::optional<std::int64_t> parted_at;
  std::int64_t other_last = 0;
  bool can_undo = false, can_redo = false;
};

/// One litter as the window shows it.
struct LitterState {
  LitterCopy litter;
  LitterView view() const { return litter.view(); }
  std::optional<Observables> observables;  // of the last step, when observed
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
  double speed = 1;                  // as asked for
  double steps_per_second = 0;       // as measured; 0 while at rest
  double microseconds_per_step = 0;  // as measured
  std::string rejected;              // why the last edit was not taken; empty when it was
  std::optional<std::uint64_t> hash;
};

/// Not thread-safe.
class Session {
 public:
  /// A new litter, or with `from` the litter of that snapshot, whose recipe is then `params`. Throws
  /// InvalidParams.
  Session(const Params& params, bool playing, int threads = 1, std::optional<Snapshot> from = {});

  void apply(const Command& command);

  /// Whether a step is wanted: now, whatever the clock says (`hurried`), or as the speed says.
  bool hurried() const { return !suspended_ && pending_ > 0; }
  bool running() const { return !suspended_ && playing_; }
  double speed() const { return speed_; }
  const Params& params() const { return simulation_.params(); }

  /// Takes one step. A bad status ends playing.
  void step();

  /// Whether anything that a state holds changed since the last `fill`.
  bool changed() const { return changed_; }

  /// Writes the state into `state` (what is measured by the clock is left as it is). With
  /// `with_hash` the simulation's hash too.
  void fill(LiveState& state, bool with_hash);

 private:
  void edit(const Edit& asked);
  void restart_as_begun();
  void restart(const Params& params);
  void begin(Simulation simulation);
  void observe(bool on);
  void record();
  void look_anew();

  std::optional<Snapshot> from_;  // where it began; none: at a new litter
  Schedule begun_with_;           // what was to change when it began
  Simulation simulation_;
  std::optional<Observer> observer_;  // none while nobody looks, and before its first step
  std::optional<Observables> observables_;
  History history_;
  const LitterField* color_by_ = &pup_fields().front();
  int threads_;  // that share a step
  bool observed_ = false, suspended_ = false, playing_, changed_ = true;
  std::int64_t pending_ = 0;  // steps still to be made by Advance
  double speed_ = 1;
  std::string rejected_;
};

}  // namespace pupflow::window
