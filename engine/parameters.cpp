#include "pupflow/parameters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

namespace pupflow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
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

const Parameter* find_parameter(std::string_view name) {
  const std::span<const Parameter> table = parameters();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Parameter& parameter) {
    return parameter.name == name;
  });
  return found == table.end() ? nullptr : &*found;
}

std::string format_value(const Parameter& parameter, double value) {
  if (parameter.kind == Parameter::Kind::choice) {
    assert(value >= 0 && value < static_cast<double>(parameter.choices.size()));
    return std::string(parameter.choices[static_cast<std::size_t>(value)]);
  }
  if (parameter.kind == Parameter::Kind::integer)
    return std::to_string(static_cast<std::int64_t>(value));
  return number_text(value);
}

std::string range_text(const Parameter& parameter) {
  if (parameter.kind == Parameter::Kind::choice) {
    std::string text;
    for (const std::string_view name : parameter.choices) {
      if (!text.empty()) text += " or ";
      text += name;
    }
    return text;
  }
  const std::string prefix = parameter.kind == Parameter::Kind::integer ? "a whole number " : "";
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
  const bool whole = parameter.kind == Parameter::Kind::real || value == std::floor(value);
  if (std::isfinite(value) && in_range && whole) return true;
  problem = out_of_range(parameter, number_text(value));
  return false;
}

bool parse_value(const Parameter& parameter, std::string_view text, Params& params,
                 Problem& problem) {
  double value = 0;
  if (parameter.kind == Parameter::Kind::choice) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) {
      problem = out_of_range(parameter, "'" + std::string(text) + "'");
      return false;
    }
    value = static_cast<double>(found - parameter.choices.begin());
  } else {
    const char* begin = text.data();
    const char* end = begin + text.size();
    if (text.starts_with('+') && !text.starts_with("+-")) ++begin;
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

/// The preconditions of step_body (refinement.h).
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

/// The course of one parameter from the change that began last: a + (b - a) s.
struct Course {
  std::int64_t begin = 0, end = 0;
  double a = 0, b = 0;

  double at(std::int64_t steps) const {
    if (steps >= end) return b;
    const double share = static_cast<double>(steps - begin) / static_cast<double>(end - begin);
    // Weights, since b - a may overflow; rounding must not leave the range of both.
    return std::clamp((1 - share) * a + share * b, std::min(a, b), std::max(a, b));
  }
};

/// The courses of all parameters that the schedule of `start` sets.
class Courses {
 public:
  explicit Courses(const Params& start) : start_(start), courses_(parameters().size()) {}

  /// Takes the changes that begin at `steps` or before. May be called again with more steps.
  void begin_those_up_to(std::int64_t steps) {
    const std::span<const Change> changes = start_.schedule.changes();
    for (; next_ < changes.size() && changes[next_].step <= steps; ++next_) {
      const Change& change = changes[next_];
      for (const Change::Setting& setting : change.settings) begin(change, setting);
    }
  }

  void write(std::int64_t steps, Params& params) const {
    for (std::size_t i = 0; i < courses_.size(); ++i) {
      if (courses_[i]) parameters()[i].set(params, courses_[i]->at(steps));
    }
  }

 private:
  void begin(const Change& change, const Change::Setting& setting) {
    std::optional<Course>& course = courses_[setting.parameter];
    const double before =
        course ? course->at(change.step) : parameters()[setting.parameter].get(start_);
    course = {change.step, change.until.value_or(change.step), before, setting.value};
  }

  const Params& start_;
  std::size_t next_ = 0;  // change to begin
  std::vector<std::optional<Course>> courses_;
};

std::string at_step(std::int64_t step) {
  return "at step " + std::to_string(step) + ": ";
}

/// What is wrong with a single change.
void check_change(const Params& params, const Change& change, std::vector<Problem>& problems) {
  const auto wrong = [&](std::string_view what, const std::string& message) {
    problems.push_back({std::string(what), at_step(change.step) + message});
  };
  const auto in_range = [](std::int64_t step) {
    return step >= 0 && static_cast<double>(step) <= kExactInteger;
  };
  if (!in_range(change.step)) wrong("step", "step must be a whole number 0 … 2^53 - 1");
  if (change.until && (*change.until <= change.step || !in_range(*change.until))) {
    wrong("until", "until = " + std::to_string(*change.until) + " must be after it");
  }
  if (change.settings.empty() == !change.pup) {
    wrong("step", change.pup ? "parameters and a pup are two changes; write them apart"
                             : "nothing changes; name a parameter, or a pup with force, heat or "
                               "turn");
  }
  for (const Change::Setting& setting : change.settings) {
    if (setting.parameter >= parameters().size()) {
      wrong("step", "there is no parameter number " + std::to_string(setting.parameter));
      continue;
    }
    const Parameter& parameter = parameters()[setting.parameter];
    Problem problem;
    if (parameter.effect != Parameter::Effect::next_step) {
      wrong(parameter.name, std::string(parameter.name) + " can only be set for the whole run");
    } else if (change.until && parameter.kind != Parameter::Kind::real) {
      wrong(parameter.name,
            std::string(parameter.name) + " changes at once and has no values between: no until");
    } else if (!check_value(parameter, setting.value, problem)) {
      wrong(parameter.name, problem.message);
    }
  }
  if (!change.pup) return;
  if (*change.pup < 0 || *change.pup >= params.pups) {
    wrong("pup", "there is no pup " + std::to_string(*change.pup) + " among " +
                     std::to_string(params.pups));
  }
  if (!change.action.acts()) wrong("pup", "nothing is done to the pup; name force, heat or turn");
  const Action& action = change.action;
  if (!std::all_of(action.force.begin(), action.force.end(),
                   [](double f) { return std::isfinite(f); }))
    wrong("force", "force must be three finite numbers");
  if (!std::isfinite(action.heat)) wrong("heat", "heat must be a finite number");
  if (!std::isfinite(action.turn.value_or(0))) wrong("turn", "turn must be a finite number");
}

/// Everything wrong with `params.schedule`: a parameter that defines the litter, values out of
/// range, a pup that is not there, and what is not allowed together at the beginning or end of a
/// change. `params` is sound without it, and so is what was done before `from`.
std::vector<Problem> check_schedule(const Params& params, std::int64_t from) {
  std::vector<Problem> problems;
  std::vector<std::int64_t> ends;  // between them all values lie between those there
  for (const Change& change : params.schedule.changes()) {
    const std::int64_t end = change.until.value_or(change.step);
    if (from > 0 && end < from) continue;
    check_change(params, change, problems);
    if (change.settings.empty()) continue;
    if (from <= 0 || change.step >= from) ends.push_back(change.step);
    ends.push_back(end);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  Params at = params;
  at.schedule = {};
  Courses courses(params);
  for (auto step = ends.begin(); problems.empty() && step != ends.end(); ++step) {
    courses.begin_those_up_to(*step);
    courses.write(*step, at);
    for (const Problem& problem : check(at)) {
      problems.push_back({problem.parameter, at_step(*step) + problem.message});
    }
  }
  return problems;
}

}  // namespace

void apply_schedule(const Params& start, std::int64_t steps, Params& params) {
  if (start.schedule.empty()) return;
  Courses courses(start);
  courses.begin_those_up_to(steps);
  courses.write(steps, params);
}

std::vector<Problem> check(const Params& params, std::int64_t from) {
  std::vector<Problem> problems;
  for (const Parameter& parameter : parameters()) {
    Problem problem;
    if (!check_value(parameter, parameter.get(params), problem)) problems.push_back(problem);
  }
  const double body_radius = params.pup_radius + params.point_radius;
  const double widest =
      params.arena_radius / std::sqrt(2.0);  // there a corner of the column is at the wall
  if (params.arena_radius <= body_radius) {
    problems.push_back(
        {"arena_radius",
         "arena_radius = " + number_text(params.arena_radius) +
             ": arena radius must exceed pup_radius + point_radius = " + number_text(body_radius)});
  } else if (params.start == Start::column && params.start_spread > widest) {
    problems.push_back(
        {"start_spread", "start_spread = " + number_text(params.start_spread) +
                             ": a pup may start outside the arena; start spread must be at most "
                             "arena_radius / sqrt(2) = " +
                             number_text(widest)});
  }
  // Rounding to float moves a body's mean by some 4e-9 in a step. Divided by dt^2 that is an
  // acceleration, which below this dt is as large as the drive's.
  constexpr double kLeastFloatStep = 1e-4;
  if (params.precision == Precision::float_ && params.dt > 0 && params.dt < kLeastFloatStep) {
    problems.push_back({"dt", "dt = " + number_text(params.dt) + ": time step must be at least " +
                                  number_text(kLeastFloatStep) +
                                  " with precision = float, whose rounding, divided by dt, pushes "
                                  "the pups"});
  }
  if (params.refinement == Refinement::consistent) check_refinement(params, problems);
  if (problems.empty()) problems = check_schedule(params, from);
  return problems;
}

bool needs_restart(const Params& a, const Params& b) {
  const std::span<const Parameter> table = parameters();
  return std::any_of(table.begin(), table.end(), [&](const Parameter& parameter) {
    return parameter.effect == Parameter::Effect::restart && parameter.get(a) != parameter.get(b);
  });
}

InvalidParams::InvalidParams(std::vector<Problem> problems)
    : std::invalid_argument(joined(problems)), problems_(std::move(problems)) {}

}  // namespace pupflow
