/// @file
/// The parameters of the model: the struct that a step reads, and the table that command line, scene
/// files, sliders, docs and range tests read.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "pupflow/schedule.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// What a pup steers about: a direction of travel of its own, or the axis of its body.
/// docs/model.md has the equations of this rule and of those below.
enum class Heading { course, body };

/// Layout of the litter at t = 0: start_centres (geometry.h).
enum class Start { column, carpet };

/// Which positions the goals are fitted to: the predicted x* (Mueller 2005) or x(t).
enum class Integrator { predictive, explicit_ };

/// Which touching lower points move a point.
enum class ContactRule { nearest, mean, sum };

/// What a smaller dt means for rigidity: alpha is per step, or per 0.01 s.
enum class Refinement { naive, consistent };

/// How body temperature is stepped: by the solution over a step, or by one Euler step.
enum class HeatRule { exact, euler };

/// Arithmetic of the point arrays.
enum class Precision { float_, double_ };

/// The paper's time step in seconds. Rigidity and contacts act per step, so this step is part of
/// the model. Refinement::consistent refers to it.
constexpr double kReferenceStep = 0.01;

/// Most points along a face edge (k): clouds of up to 6 k^2 points.
constexpr int kMaxFacePoints = 32;

/// 2^53 - 1, the largest integer that a double and JSON hold exactly.
constexpr double kExactInteger = 9007199254740991.0;

/// The model's parameters with the paper's values. Lengths are in arena units, times in model
/// seconds, temperatures in the paper's normalised units (0.6 is 37 degrees C). A plain value: edit
/// a copy, `check` it, give it to a Simulation. `parameters()` has names, symbols, ranges, sources.
struct Params {
  // The litter
  int pups = 12;               ///< number of pups
  int face_points = 7;         ///< points along a face edge, k; a pup has 6 k^2 points
  double arena_radius = 2.0;   ///< length; radius of the round wall
  double pup_radius = 0.25;    ///< length; radius of the sphere on which a pup's points rest
  double point_radius = 0.05;  ///< length; radius of the sphere at each point, by which it touches

  // Body
  double rigidity = 0.7;     ///< per step, 0 ... 1; share of the way to its goal of each point
  double deformation = 0.5;  ///< 0 ... 1; share of the quadratic fit in the goals
  double gravity = 10.0;     ///< length/s^2; acceleration downwards
  double drive = 1.0;        ///< length/s^2; acceleration along the direction of travel

  // Heat
  double ambient_temperature = 0.4;    ///< normalised; of the arena, felt where nothing touches
  double preferred_temperature = 0.6;  ///< normalised; body temperature that a pup seeks
  double air_conductance = 0.9;        ///< 1/s; rate of heat loss through the exposed surface
  double contact_conductance = 1.0;    ///< 1/s; rate of heat exchange through the touching surface
  double thermogenesis = 0.055;        ///< normalised/s; heat that each pup produces

  // Steering
  double sensitivity = 38.0;     ///< 1; steepness of the two temperature sensors
  double steering_gain = 200.0;  ///< 1; gain from sensor contrast to turning

  // Start, and rules with several readings
  double initial_temperature = 0.6;   ///< normalised; body temperature of every pup at t = 0
  Heading heading = Heading::course;  ///< what a pup steers about
  Start start = Start::column;        ///< layout of the litter at t = 0
  double start_spread = 0.25;         ///< length; half-width of the drop column in x and y
  ContactRule contact = ContactRule::nearest;      ///< which touching points move a point
  Refinement refinement = Refinement::naive;       ///< what a smaller dt means for rigidity
  Integrator integrator = Integrator::predictive;  ///< which positions the goals are fitted to
  HeatRule heat = HeatRule::exact;                 ///< how body temperature is stepped

  // The run
  double dt = 0.01;                          ///< s; length of a step
  std::int64_t steps = 1500;                 ///< steps; length of a run
  std::int64_t discard = 500;                ///< steps; at the beginning, left out of a run's means
  std::int64_t flow_lag = 1;                 ///< steps; over which pup flow takes the change of A
  std::int64_t seed = 1;                     ///< selects the random numbers: same seed, same bits
  Precision precision = Precision::double_;  ///< arithmetic of the point arrays
  Schedule schedule;                         ///< what changes during the run; not in parameters()

  friend bool operator==(const Params&, const Params&) = default;
};

/// One row of the table.
struct Parameter {
  /// What its values are: any number, whole numbers, or the names of an enum.
  enum class Kind { real, integer, choice };
  /// When a change has its effect. next_step: in the next step. restart: it defines the litter, so
  /// a new Simulation is needed. run: it belongs to a run, not to the litter.
  enum class Effect { next_step, restart, run };

  std::string_view name;    ///< as typed: --set name=value
  std::string_view symbol;  ///< as written in the paper and the docs
  std::string_view title;   ///< a few words for labels
  std::string_view unit;    ///< empty when dimensionless
  std::string_view group;   ///< heading under which it is listed
  std::string_view source;  ///< where the default comes from
  std::string_view doc;     ///< one line, full sentence
  Kind kind;                ///< what its values are
  Effect effect;            ///< when a change has its effect
  double min;               ///< least allowed value; infinite where any finite one goes
  double max;               ///< greatest allowed value; infinite where any finite one goes
  bool min_open;            ///< min itself is excluded
  double slider_min;        ///< low end of a slider; a lower value can be typed
  double slider_max;        ///< high end of a slider; a higher value can be typed
  bool slider_log;          ///< whether the slider is logarithmic
  std::span<const std::string_view> choices;  ///< names of a choice, in the order of its enum
  double (*get)(const Params&);               ///< integers and choices as whole numbers
  void (*set)(Params&, double);               ///< takes what `get` gives; checks nothing
  double before;  ///< value of a file that was written before this parameter existed

  /// The value in Params{}, as `get` gives it.
  double default_value() const { return get(Params{}); }
};

/// All parameters in the order in which they are shown. Lives as long as the program.
std::span<const Parameter> parameters();

/// The row called `name`, or nullptr.
const Parameter* find_parameter(std::string_view name);

/// `value` as the shortest text that `parse_value` reads back to the same number. For a choice it
/// must be the number of one of its names.
std::string format_value(const Parameter& parameter, double value);
/// The same of the value that `params` has.
inline std::string format_value(const Parameter& parameter, const Params& params) {
  return format_value(parameter, parameter.get(params));
}

/// The allowed range in words, e.g. "0 ... 1", "> 0", "course or body".
std::string range_text(const Parameter& parameter);

/// Something wrong with a parameter set: the parameter's name, and one sentence that says what
/// would be right.
struct Problem {
  std::string parameter;  ///< its name
  std::string message;    ///< one sentence
};

/// Reads `text` into `params`. Returns false and explains in `problem` when the text is no number
/// of the right kind, no known choice, or out of range; `params` is then unchanged.
bool parse_value(const Parameter& parameter, std::string_view text, Params& params,
                 Problem& problem);

/// Whether `value` is in the range of `parameter` and whole where it must be. Otherwise `problem`
/// says what would be right.
bool check_value(const Parameter& parameter, double value, Problem& problem);

/// Everything wrong with `params`: values out of range first, then combinations that are not
/// allowed, then, where there is none of these, its schedule. Empty when the set is sound. What the
/// schedule does before `from` steps are done counts as sound.
std::vector<Problem> check(const Params& params, std::int64_t from = 0);

/// Whether `a` and `b` differ in a parameter of Effect::restart, so that going from one to the
/// other needs a new litter.
bool needs_restart(const Params& a, const Params& b);

/// What the schedule of `start` makes of it after `steps` steps, for the next one: writes the
/// parameters that it has changed by then to `params` and leaves the others alone.
void apply_schedule(const Params& start, std::int64_t steps, Params& params);

/// Points per pup, n = 6 k^2.
inline int points_per_pup(const Params& params) {
  return 6 * params.face_points * params.face_points;
}

/// Thrown where a sound parameter set is needed. what() lists every problem, one per line.
class InvalidParams : public std::invalid_argument {
 public:
  /// `problems` is not empty.
  explicit InvalidParams(std::vector<Problem> problems);

  /// What is wrong, as `check` lists it.
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace pupflow
#pragma GCC visibility pop
