#include "pupflow/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace pupflow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kExactInteger = 9007199254740991.0;  // 2^53 - 1: whole in a double and in JSON

constexpr std::array<std::string_view, 2> kHeadingNames{"course", "body"};
constexpr std::array<std::string_view, 2> kStartNames{"column", "carpet"};
constexpr std::array<std::string_view, 3> kContactNames{"nearest", "mean", "sum"};
constexpr std::array<std::string_view, 2> kRefinementNames{"naive", "consistent"};
constexpr std::array<std::string_view, 2> kIntegratorNames{"predictive", "explicit"};
constexpr std::array<std::string_view, 2> kHeatNames{"exact", "euler"};
constexpr std::array<std::string_view, 2> kPrecisionNames{"float", "double"};

using Kind = Parameter::Kind;
using Effect = Parameter::Effect;

/// Allowed range and slider of one row.
struct Range {
  double min, max;
  double slider_min, slider_max;
  bool min_open = false;
  bool slider_log = false;
};

struct Words {
  std::string_view name, symbol, title, unit, group, source, doc;
};

/// A row whose accessors reach the member `Member` of Params.
template <auto Member>
constexpr Parameter row(Effect effect, Range range, const Words& words,
                        std::span<const std::string_view> choices = {},
                        double before = static_cast<double>(Params{}.*Member)) {
  using Value = std::remove_cvref_t<decltype(Params{}.*Member)>;
  constexpr Kind kind = std::is_enum_v<Value>       ? Kind::choice
                        : std::is_integral_v<Value> ? Kind::integer
                                                    : Kind::real;
  return Parameter{words.name,
                   words.symbol,
                   words.title,
                   words.unit,
                   words.group,
                   words.source,
                   words.doc,
                   kind,
                   effect,
                   range.min,
                   range.max,
                   range.min_open,
                   range.slider_min,
                   range.slider_max,
                   range.slider_log,
                   choices,
                   [](const Params& p) { return static_cast<double>(p.*Member); },
                   [](Params& p, double value) {
                     if constexpr (std::is_same_v<Value, double>) {
                       p.*Member = value;
                     } else {
                       p.*Member = static_cast<Value>(static_cast<std::int64_t>(value));
                     }
                   },
                   before};
}

template <auto Member>
constexpr Parameter choice(Effect effect, std::span<const std::string_view> names,
                           const Words& words,
                           std::remove_cvref_t<decltype(Params{}.*Member)> before = Params{}.*
                                                                                    Member) {
  const double last = static_cast<double>(names.size()) - 1;
  return row<Member>(effect, {0, last, 0, last}, words, names, static_cast<double>(before));
}

constexpr std::string_view kPaper = "Wilson 2017";
constexpr std::string_view kAuthor2d = "not in the paper; the author's 2-D model";
constexpr std::string_view kProgram = "this program";

constexpr std::array kTable{
    row<&Params::ambient_temperature>(
        Effect::next_step, {-kInfinity, kInfinity, 0, 1},
        {"ta", "T_a", "ambient temperature", "", "heat", kPaper,
         "Temperature of the arena; every afferent that touches nobody reads it. 0.6 "
         "is 37 deg C."}),
    row<&Params::rigidity>(
        Effect::next_step, {0, 1, 0, 1},
        {"alpha", "α", "rigidity", "per step", "body", kPaper,
         "Share of the way to its goal that a point goes in one step; 1 is rigid, 0 "
         "a loose cloud."}),
    row<&Params::deformation>(
        Effect::next_step, {0, 1, 0, 1},
        {"beta", "β", "deformation", "", "body", kPaper,
         "How far goals follow the best quadratic fit (1) instead of the best "
         "rotation (0); 1 has no shape of its own."}),
    row<&Params::gravity>(
        Effect::next_step, {0, kInfinity, 0, 50},
        {"gravity", "g", "gravity", "length/s²", "body", kPaper, "Acceleration downwards."}),
    choice<&Params::contact>(
        Effect::next_step, kContactNames,
        {"contact", "", "contact rule", "", "body", "readings of Wilson 2017",
         "nearest: a point is moved by its nearest touching lower point alone; mean: by the mean "
         "over all of them; sum: by their sum."},
        ContactRule::sum),
    row<&Params::preferred_temperature>(Effect::next_step, {-kInfinity, kInfinity, 0, 1},
                                        {"tp", "T_p", "preferred temperature", "", "heat", kPaper,
                                         "Body temperature that a pup seeks; 0.6 is 37 deg C."}),
    row<&Params::air_conductance>(Effect::next_step, {0, kInfinity, 0, 5},
                                  {"k1", "k₁", "conductance to the air", "1/s", "heat", kPaper,
                                   "Rate of heat loss through the exposed surface."}),
    row<&Params::contact_conductance>(Effect::next_step, {0, kInfinity, 0, 5},
                                      {"k2", "k₂", "conductance to others", "1/s", "heat", kPaper,
                                       "Rate of heat exchange through the touching surface."}),
    row<&Params::thermogenesis>(
        Effect::next_step, {-kInfinity, kInfinity, 0, 0.5},
        {"g", "G", "thermogenesis", "1/s", "heat", kPaper, "Heat that each pup makes."}),
    choice<&Params::heat>(
        Effect::next_step, kHeatNames,
        {"heat", "", "heat rule", "", "heat", "exact: this program; euler: Wilson 2017",
         "How body temperature is stepped: the exact solution over the step, or "
         "forward Euler."}),
    row<&Params::initial_temperature>(Effect::restart, {-kInfinity, kInfinity, 0, 1},
                                      {"tb0", "T_b(0)", "initial body temperature", "", "heat",
                                       kAuthor2d, "Body temperature of every pup at t = 0."}),
    row<&Params::drive>(Effect::next_step, {0, kInfinity, 0, 10},
                        {"drive", "f", "drive", "length/s²", "steering", kPaper,
                         "Acceleration of a pup along its direction of travel."}),
    row<&Params::sensitivity>(
        Effect::next_step, {-kInfinity, kInfinity, 0, 200},
        {"sigma", "σ", "sensitivity", "", "steering",
         "not in the paper; 0.01 per deg C² in the author's 2-D model × 61.67²",
         "Steepness of the two temperature sensors."}),
    row<&Params::steering_gain>(Effect::next_step, {0, kInfinity, 0, 1000},
                                {"v", "v", "steering gain", "", "steering", kAuthor2d,
                                 "Gain from sensor contrast to turning."}),
    choice<&Params::heading>(
        Effect::next_step, kHeadingNames,
        {"heading", "", "heading", "", "steering", "both readings of Wilson 2017",
         "course: the direction of travel is the pup's own state and turns; body: it is taken from "
         "the body axis at every step."}),
    row<&Params::pups>(
        Effect::restart, {0, 10000, 0, 200},
        {"pups", "N", "pups", "", "litter", kPaper, "Number of pups in the litter."}),
    row<&Params::face_points>(Effect::restart, {2, kMaxFacePoints, 2, 15},
                              {"face_points", "k", "points along a face edge", "", "litter", kPaper,
                               "Each pup has n = 6 k² points on its surface."}),
    row<&Params::pup_radius>(Effect::restart, {0, 1e6, 0.05, 1, true},
                             {"pup_radius", "r_pup", "pup radius", "length", "litter", kPaper,
                              "Radius of the sphere on which a pup's points rest."}),
    row<&Params::point_radius>(
        Effect::restart, {0, 1e6, 0.01, 0.3, true},
        {"point_radius", "r_point", "point radius", "length", "litter", kPaper,
         "Radius of the sphere at each point, by which it touches."}),
    row<&Params::arena_radius>(Effect::restart, {0, 1e9, 0.5, 10, true},
                               {"arena_radius", "r_arena", "arena radius", "length", "litter",
                                kPaper, "Radius of the round wall; must exceed r_pup + r_point."}),
    choice<&Params::start>(
        Effect::restart, kStartNames,
        {"start", "", "start layout", "", "litter", "column: Wilson 2017",
         "column: dropped one above the other at the centre; carpet: laid out over "
         "the floor, for many pups."}),
    row<&Params::start_spread>(
        Effect::restart, {0, 1e6, 0, 1.4},
        {"start_spread", "", "start spread", "length", "litter", kPaper,
         "Half-width of the drop column in x and y; at most r_arena / √2, for all pups to "
         "start inside."}),
    row<&Params::dt>(Effect::next_step, {0, 1e3, 0.001, 0.05, true, true},
                     {"dt", "h", "time step", "s", "run", kPaper,
                      "Length of a step. Rigidity acts per step, so 0.01 is part of the model."}),
    choice<&Params::refinement>(
        Effect::next_step, kRefinementNames,
        {"refinement", "", "refinement", "", "run", "naive: Wilson 2017; consistent: this program",
         "naive: rigidity per step, whatever dt; consistent: per 0.01 s, so that a smaller dt is "
         "the same body."}),
    choice<&Params::integrator>(Effect::next_step, kIntegratorNames,
                                {"integrator", "", "integrator", "", "run",
                                 "predictive: Müller 2005; explicit: Wilson 2017",
                                 "predictive: goals from the predicted points; explicit: from the "
                                 "current ones, undamped."}),
    row<&Params::steps>(Effect::run, {0, kExactInteger, 0, 10000},
                        {"steps", "", "steps", "", "run", kPaper, "Length of a run."}),
    row<&Params::discard>(Effect::run, {0, kExactInteger, 0, 10000},
                          {"discard", "", "steps left out", "", "run", kPaper,
                           "Steps at the beginning that stay out of a run's means."}),
    row<&Params::flow_lag>(Effect::run, {1, 10000, 1, 100},
                           {"flow_lag", "", "lag of pup flow", "steps", "run", kPaper,
                            "Pup flow is the change of A over so many steps, divided by their "
                            "time."}),
    row<&Params::seed>(Effect::restart, {0, kExactInteger, 0, 1000},
                       {"seed", "", "seed", "", "run", kProgram,
                        "Fixes every random number: same seed, same bits."}),
    choice<&Params::precision>(
        Effect::restart, kPrecisionNames,
        {"precision", "", "precision", "", "run", kProgram,
         "Arithmetic of the points; temperatures and headings are always double."}),
};

std::string number_text(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

Problem out_of_range(const Parameter& parameter, const std::string& value) {
  return {std::string(parameter.name), std::string(parameter.name) + " = " + value + ": " +
                                           std::string(parameter.title) + " must be " +
                                           range_text(parameter)};
}

std::string joined(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.message;
  }
  return text;
}

}  // namespace

std::span<const Parameter> parameters() {
  return kTable;
}

const Parameter* find_parameter(std::string_view name) {
  const auto found = std::find_if(kTable.begin(), kTable.end(), [&](const Parameter& parameter) {
    return parameter.name == name;
  });
  return found == kTable.end() ? nullptr : &*found;
}

std::string format_value(const Parameter& parameter, double value) {
  if (parameter.kind == Kind::choice) {
    return std::string(parameter.choices[static_cast<std::size_t>(value)]);
  }
  if (parameter.kind == Kind::integer) return std::to_string(static_cast<std::int64_t>(value));
  return number_text(value);
}

std::string range_text(const Parameter& parameter) {
  if (parameter.kind == Kind::choice) {
    std::string text;
    for (const std::string_view name : parameter.choices) {
      if (!text.empty()) text += " or ";
      text += name;
    }
    return text;
  }
  const std::string prefix = parameter.kind == Kind::integer ? "a whole number " : "";
  if (parameter.min == -kInfinity) return prefix + "any finite number";
  const std::string low = number_text(parameter.min);
  if (parameter.max == kInfinity) return prefix + (parameter.min_open ? "> " : "≥ ") + low;
  const std::string high = parameter.max == kExactInteger ? "2^53 - 1" : number_text(parameter.max);
  if (parameter.min_open) return prefix + "> " + low + " and ≤ " + high;
  return prefix + low + " … " + high;
}

bool check_value(const Parameter& parameter, double value, Problem& problem) {
  const bool in_range = (parameter.min_open ? value > parameter.min : value >= parameter.min) &&
                        value <= parameter.max;
  const bool whole = parameter.kind == Kind::real || value == std::floor(value);
  if (std::isfinite(value) && in_range && whole) return true;
  problem = out_of_range(parameter, number_text(value));
  return false;
}

bool parse_value(const Parameter& parameter, std::string_view text, Params& params,
                 Problem& problem) {
  double value = 0;
  if (parameter.kind == Kind::choice) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) {
      problem = out_of_range(parameter, "'" + std::string(text) + "'");
      return false;
    }
    value = static_cast<double>(found - parameter.choices.begin());
  } else {
    const char* begin = text.data();
    const char* end = begin + text.size();
    if (begin != end && *begin == '+') ++begin;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end) {
      problem = out_of_range(parameter, "'" + std::string(text) + "'");
      return false;
    }
    if (!check_value(parameter, value, problem)) return false;
  }
  parameter.set(params, value);
  return true;
}

namespace {

/// What refinement.h needs.
void check_refinement(const Params& params, std::vector<Problem>& problems) {
  if (params.dt > kReferenceStep) {
    problems.push_back({"refinement", "refinement = consistent: dt = " + number_text(params.dt) +
                                          " must be at most " + number_text(kReferenceStep) +
                                          ", the step that it refines"});
  }
  if (params.dt < kReferenceStep && params.rigidity == 1 &&
      params.integrator == Integrator::predictive) {
    problems.push_back({"refinement",
                        "refinement = consistent: alpha = 1 stops deformation within one step and "
                        "has no finer form; alpha must be below 1, or dt " +
                            number_text(kReferenceStep)});
  }
}

}  // namespace

std::vector<Problem> check(const Params& params) {
  std::vector<Problem> problems;
  for (const Parameter& parameter : kTable) {
    Problem problem;
    if (!check_value(parameter, parameter.get(params), problem)) problems.push_back(problem);
  }
  const double reach = params.pup_radius + params.point_radius;
  const double widest = params.arena_radius / std::sqrt(2.0);  // then a corner is at the wall
  if (params.arena_radius <= reach) {
    problems.push_back(
        {"arena_radius",
         "arena_radius = " + number_text(params.arena_radius) +
             ": arena radius must exceed pup_radius + point_radius = " + number_text(reach)});
  } else if (params.start == Start::column && params.start_spread > widest) {
    problems.push_back(
        {"start_spread", "start_spread = " + number_text(params.start_spread) +
                             ": a pup may start outside the arena; start spread must be at most "
                             "arena_radius / sqrt(2) = " +
                             number_text(widest)});
  }
  // Rounding moves a body's mean by some 4e-9 in a step; over dt that is a velocity, and from here
  // on an acceleration like the drive's.
  constexpr double kLeastFloatStep = 1e-4;
  if (params.precision == Precision::float_ && params.dt > 0 && params.dt < kLeastFloatStep) {
    problems.push_back({"dt", "dt = " + number_text(params.dt) + ": time step must be at least " +
                                  number_text(kLeastFloatStep) +
                                  " with precision = float, whose rounding, divided by dt, pushes "
                                  "the pups"});
  }
  if (params.refinement == Refinement::consistent) check_refinement(params, problems);
  return problems;
}

bool needs_restart(const Params& a, const Params& b) {
  return std::any_of(kTable.begin(), kTable.end(), [&](const Parameter& parameter) {
    return parameter.effect == Effect::restart && parameter.get(a) != parameter.get(b);
  });
}

InvalidParams::InvalidParams(std::vector<Problem> problems)
    : std::invalid_argument(joined(problems)), problems_(std::move(problems)) {}

}  // namespace pupflow
