#include "pupflow/parameters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

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

}  // namespace

std::vector<Problem> check(const Params& params) {
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
  if (problems.empty()) problems = check_schedule(params);
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
