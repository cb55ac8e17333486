// Every parameter of the model, once: the struct that the engine steps with, and the table that
// command line, scene files, sliders, docs and range tests all read.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pupflow {

enum class Heading { course, body };              // which direction a pup steers about
enum class Start { column, carpet };              // how the litter is laid out at t = 0
enum class Integrator { predictive, explicit_ };  // goals from x* (Mueller 2005, sec. 3.3) or x(t)
enum class ContactRule { nearest, mean, sum };    // which touching points move a point (contact.h)
enum class Refinement { naive, consistent };      // alpha per step, or per 0.01 s (refinement.h)
enum class HeatRule { exact, euler };      // solution of the linear equation, or one Euler step
enum class Precision { float_, double_ };  // arithmetic of the point arrays

/// The step at which rigidity and contacts are the paper's; Refinement::consistent keeps to it.
constexpr double kReferenceStep = 0.01;

/// Most points along a face edge (k): clouds of up to 6 k^2 points.
constexpr int kMaxFacePoints = 32;

/// The model's parameters with the paper's values. Lengths in arena units, time in model seconds,
/// temperatures in the paper's normalised units (0.6 is 37 degrees C). A plain value: edit a copy,
/// `check` it, hand it to a Simulation. Symbols, ranges and sources stand in `parameters()`.
struct Params {
  int pups = 12;
  int face_points = 7;
  double arena_radius = 2.0;
  double pup_radius = 0.25;
  double point_radius = 0.05;
  double dt = 0.01;
  double rigidity = 0.7;
  double deformation = 0.5;
  double gravity = 10.0;
  double drive = 1.0;
  double ambient_temperature = 0.4;
  double preferred_temperature = 0.6;
  double air_conductance = 0.9;
  double contact_conductance = 1.0;
  double thermogenesis = 0.055;
  double sensitivity = 38.0;
  double steering_gain = 200.0;
  double initial_temperature = 0.6;
  Heading heading = Heading::course;
  Start start = Start::column;
  double start_spread = 0.25;
  ContactRule contact = ContactRule::nearest;
  Refinement refinement = Refinement::naive;
  Integrator integrator = Integrator::predictive;
  HeatRule heat = HeatRule::exact;
  std::int64_t steps = 1500;
  std::int64_t discard = 500;
  std::int64_t flow_lag = 1;
  std::int64_t seed = 1;
  Precision precision = Precision::double_;

  friend bool operator==(const Params&, const Params&) = default;
};

/// One row of the table.
struct Parameter {
  enum class Kind { real, integer, choice };
  enum class Effect { next_step, restart, run };  // restart: defines the litter; run: how long, how

  std::string_view name;    // as typed: --set name=value
  std::string_view symbol;  // as written in the paper and the docs
  std::string_view title;   // a few words for labels
  std::string_view unit;    // empty when dimensionless
  std::string_view group;   // heading under which it is listed
  std::string_view source;  // where the default comes from
  std::string_view doc;     // one line, full sentence
  Kind kind;
  Effect effect;
  double min, max;                // allowed range; infinite where any finite value goes
  bool min_open;                  // min itself is excluded
  double slider_min, slider_max;  // span of a slider; a wider value can be typed
  bool slider_log;
  std::span<const std::string_view> choices;  // names of a choice, in the order of its enum
  double (*get)(const Params&);               // integers and choices as whole numbers
  void (*set)(Params&, double);
  double before;  // what a file means that was written before this parameter existed

  double default_value() const { return get(Params{}); }
};

/// All parameters in the order in which they are shown. Lives as long as the program.
std::span<const Parameter> parameters();

/// The row called `name`, or nullptr.
const Parameter* find_parameter(std::string_view name);

/// `value` as text that `parse_value` reads back to the same number (shortest form).
std::string format_value(const Parameter& parameter, double value);
inline std::string format_value(const Parameter& parameter, const Params& params) {
  return format_value(parameter, parameter.get(params));
}

/// The allowed range in words, e.g. "0 ... 1", "> 0", "course or body".
std::string range_text(const Parameter& parameter);

/// Something wrong with a parameter set: which parameter, and one sentence saying what would be
/// right.
struct Problem {
  std::string parameter;
  std::string message;
};

/// Reads `text` into `params`. Returns false and explains in `problem` when the text is no number
/// of the right kind, no known choice, or out of range; `params` is then unchanged.
bool parse_value(const Parameter& parameter, std::string_view text, Params& params,
                 Problem& problem);

/// Whether `value` is one that `parameter` may take on its own; otherwise says why in `problem`.
bool check_value(const Parameter& parameter, double value, Problem& problem);

/// Everything wrong with `params`, ranges first, then what does not fit together; empty when sound.
std::vector<Problem> check(const Params& params);

/// Whether going from `a` to `b` needs a new litter (some Effect::restart parameter differs).
bool needs_restart(const Params& a, const Params& b);

/// Points per pup, n = 6 k^2.
inline int points_per_pup(const Params& params) {
  return 6 * params.face_points * params.face_points;
}

/// Thrown by what needs a sound parameter set; what() lists every problem, one a line.
class InvalidParams : public std::invalid_argument {
 public:
  explicit InvalidParams(std::vector<Problem> problems);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace pupflow
