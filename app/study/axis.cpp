#include "app/study/axis.h"

#include <algorithm>
#include <set>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "app/study/spaced.h"

namespace pupflow::study {
namespace {

using io::refuse;
using Parts = std::vector<std::string_view>;

/// A text "name=range" in two.
struct Typed {
  const Parameter& parameter;
  std::string option;  // "--vary NAME", the beginning of messages
  std::string range;
};

[[noreturn]] void refuse_form(const std::string& text, const char* forms) {
  refuse("--vary " + io::quoted(text) + ": write " + forms);
}

Typed parse_name(const std::string& text, const char* forms) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse_form(text, forms);
  const std::string name = text.substr(0, equals);
  if (name == "seed")
    refuse("--vary seed: every run has a seed of its own; use --seeds N for more runs");
  return {parameter_named(name, "--vary"), "--vary " + name, text.substr(equals + 1)};
}

double value_of(const Parameter& parameter, std::string_view text) {
  Params scratch;
  Problem problem;
  if (!parse_value(parameter, text, scratch, problem)) {
    refuse("--vary: " + problem.message + io::did_you_mean(text, parameter.choices));
  }
  return parameter.get(scratch);
}

/// The two ends of a range, which must differ.
std::vector<double> ends_of(const Typed& typed, const Parts& parts) {
  const Parameter& parameter = typed.parameter;
  if (parameter.kind == Parameter::Kind::choice) {
    refuse(typed.option + ": list its choices, e.g. " + std::string(parameter.name) + "=" +
           std::string(parameter.choices[0]) + "," + std::string(parameter.choices[1]));
  }
  std::vector<double> ends{value_of(parameter, parts[0]), value_of(parameter, parts[1])};
  if (ends[0] == ends[1]) {
    refuse(typed.option + ": " + std::string(parts[0]) + " to " + std::string(parts[1]) +
           " is no range");
  }
  return ends;
}

std::vector<double> stepped_values(const Typed& typed, const Parts& parts) {
  const std::string_view step = parts[2].substr(parts[2].find('=') + 1);
  if (!(io::read_number<double>(step).value_or(0) > 0)) {
    refuse(typed.option + ": the step in from:to:step=S is " + io::quoted(step) +
           "; it must be a number above 0");
  }
  std::vector<double> values = stepped(parts[0], parts[1], step, kMostValues);
  if (values.empty()) {
    refuse(typed.option + ": steps of " + std::string(step) + " make more than " +
           std::to_string(kMostValues) + " values; take a larger step");
  }
  return values;
}

std::vector<double> counted_values(const Typed& typed, const Parts& parts) {
  const std::int64_t count = io::read_number<std::int64_t>(parts[2]).value_or(0);
  if (count >= 2 && count <= kMostValues) return spaced(parts[0], parts[1], count);
  refuse(typed.option + ": the count in from:to:count is " + io::quoted(parts[2]) +
         "; it must be a whole number from 2 to " + std::to_string(kMostValues));
}

std::vector<double> range_values(const Typed& typed, const Parts& parts) {
  ends_of(typed, parts);
  std::vector<double> values =
      parts[2].starts_with("step=") ? stepped_values(typed, parts) : counted_values(typed, parts);
  for (const double value : values) {
    Problem problem;
    if (check_value(typed.parameter, value, problem)) continue;
    refuse(typed.option + ": " + std::to_string(values.size()) + " values from " +
           std::string(parts[0]) + " to " + std::string(parts[1]) +
           " are not all allowed: " + problem.message);
  }
  return values;
}

std::vector<double> listed_values(const Typed& typed) {
  std::vector<double> values;
  std::set<double> seen;
  const Parts parts = io::split(typed.range, ',');
  if (std::ssize(parts) > kMostValues)
    refuse(typed.option + ": lists more than " + std::to_string(kMostValues) + " values");
  for (const std::string_view part : parts) {
    values.push_back(value_of(typed.parameter, part));
    if (!seen.insert(values.back()).second)
      refuse(typed.option + ": " + std::string(part) + " is listed twice");
  }
  return values;
}

}  // namespace

const Parameter& parameter_named(const std::string& name, const std::string& where) {
  if (const Parameter* parameter = find_parameter(name)) return *parameter;
  std::vector<std::string_view> names;
  for (const Parameter& candidate : parameters()) names.push_back(candidate.name);
  const std::string meant = io::did_you_mean(name, names);
  refuse(where + ": unknown parameter " + io::quoted(name) +
         (meant.empty() ? "; see 'pupflow params'" : meant));
}

Axis parse_axis(const std::string& text) {
  constexpr const char* kForms = "name=from:to:count, name=from:to:step=S or name=a,b,c";
  const Typed typed = parse_name(text, kForms);
  const Parts parts = io::split(typed.range, ':');
  if (parts.size() == 3) return {&typed.parameter, range_values(typed, parts)};
  if (parts.size() != 1) refuse_form(text, kForms);
  return {&typed.parameter, listed_values(typed)};
}

Span parse_span(const std::string& text) {
  constexpr const char* kForms = "name=from:to or name=a,b,c with --lhs";
  const Typed typed = parse_name(text, kForms);
  const Parts parts = io::split(typed.range, ':');
  if (parts.size() == 2) return {{&typed.parameter, ends_of(typed, parts)}, true};
  if (parts.size() != 1) refuse_form(text, kForms);
  return {{&typed.parameter, listed_values(typed)}, false};
}

std::string axis_text(const Axis& axis, char separator) {
  return std::string(axis.parameter->name) + "=" +
         io::joined(axis.values, std::string_view(&separator, 1),
                    [&](double value) { return format_value(*axis.parameter, value); });
}

std::string span_text(const Span& span) {
  return axis_text(span.axis, span.between ? ':' : ',');
}

}  // namespace pupflow::study
