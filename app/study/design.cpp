#include "app/study/design.h"

#include <algorithm>
#include <set>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "pupflow/ensemble.h"

namespace pupflow::study {
namespace {

constexpr std::int64_t kMostRuns = 100'000'000;
constexpr std::int64_t kMostValues = 1'000'000, kMostShards = 1'000'000;

using io::refuse;

double value_of(const Parameter& parameter, std::string_view text) {
  Params scratch;
  Problem problem;
  if (!parse_value(parameter, text, scratch, problem)) refuse("--vary: " + problem.message);
  return parameter.get(scratch);
}

std::vector<double> spaced_values(const Parameter& parameter,
                                  const std::vector<std::string_view>& parts) {
  const std::string name(parameter.name);
  if (parameter.kind == Parameter::Kind::choice) {
    refuse("--vary " + name + ": list its choices, e.g. " + name + "=" +
           std::string(parameter.choices[0]) + "," + std::string(parameter.choices[1]));
  }
  const std::int64_t count = io::read_number<std::int64_t>(parts[2]).value_or(0);
  if (count < 2 || count > kMostValues) {
    refuse("--vary " + name + ": the count in from:to:count is " + io::quoted(parts[2]) +
           "; it must be a whole number from 2");
  }
  const double from = value_of(parameter, parts[0]), to = value_of(parameter, parts[1]);
  const std::string ends = std::string(parts[0]) + " to " + std::string(parts[1]);
  if (from == to) refuse("--vary " + name + ": " + ends + " is no range");
  std::vector<double> values;
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double value = i == count - 1 ? to : from + (to - from) * share;
    Problem problem;
    if (!check_value(parameter, value, problem)) {
      refuse("--vary " + name + ": " + std::to_string(count) + " values from " + ends +
             " are not all allowed: " + problem.message);
    }
    values.push_back(value);
  }
  return values;
}

}  // namespace

Axis parse_axis(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    refuse("--vary " + io::quoted(text) + ": write name=from:to:count or name=a,b,c");
  }
  const std::string name = text.substr(0, equals), range = text.substr(equals + 1);
  const Parameter* parameter = find_parameter(name);
  if (parameter == nullptr) {
    std::vector<std::string_view> names;
    for (const Parameter& candidate : parameters()) names.push_back(candidate.name);
    const std::string meant = io::did_you_mean(name, names);
    refuse("--vary: unknown parameter " + io::quoted(name) +
           (meant.empty() ? "; see 'pupflow params'" : meant));
  }
  if (name == "seed")
    refuse("--vary seed: every run has a seed of its own; use --seeds N for more runs");
  const auto parts = io::split(range, ':');
  if (parts.size() == 3) return {parameter, spaced_values(*parameter, parts)};
  if (parts.size() != 1)
    refuse("--vary " + io::quoted(text) + ": write name=from:to:count or name=a,b,c");
  Axis axis{parameter, {}};
  for (const std::string_view part : io::split(range, ',')) {
    const double value = value_of(*parameter, part);
    if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end()) {
      refuse("--vary " + name + ": " + std::string(part) + " is listed twice");
    }
    axis.values.push_back(value);
  }
  return axis;
}

Shard parse_shard(const std::string& text) {
  const auto parts = io::split(text, '/');
  Shard shard{0, 0};
  if (parts.size() == 2) {
    shard.number = io::read_number<std::int64_t>(parts[0]).value_or(0);
    shard.of = io::read_number<std::int64_t>(parts[1]).value_or(0);
  }
  if (shard.number < 1 || shard.number > shard.of || shard.of > kMostShards) {
    refuse("--shard " + io::quoted(text) + ": write i/n with i from 1 to n, e.g. 1/4");
  }
  return shard;
}

std::int64_t Design::points() const {
  std::int64_t count = 1;
  for (const Axis& axis : axes) {
    count *= static_cast<std::int64_t>(axis.values.size());
    if (count > kMostRuns) return kMostRuns + 1;  // refused by check_design; no overflow on the way
  }
  return count;
}

std::vector<double> Design::values_at(std::int64_t point) const {
  std::vector<double> values(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    const auto size = static_cast<std::int64_t>(axes[a].values.size());
    values[a] = axes[a].values[static_cast<std::size_t>(point % size)];
    point /= size;
  }
  return values;
}

Params Design::params_of(std::int64_t run) const {
  Params params = base;
  const std::vector<double> values = values_at(run / seeds);
  for (std::size_t a = 0; a < axes.size(); ++a) axes[a].parameter->set(params, values[a]);
  params.seed = run_seed(base.seed, run);
  return params;
}

std::vector<std::int64_t> Design::own_runs() const {
  std::vector<std::int64_t> own;
  for (std::int64_t run = shard.number - 1; run < runs(); run += shard.of) own.push_back(run);
  return own;
}

void check_design(const Design& design) {
  std::set<const Parameter*> seen;
  for (const Axis& axis : design.axes) {
    if (!seen.insert(axis.parameter).second) {
      refuse("--vary " + std::string(axis.parameter->name) + " is given twice");
    }
  }
  const std::int64_t points = design.points();
  if (points > kMostRuns || design.seeds > kMostRuns || design.runs() > kMostRuns) {
    refuse("the sweep has more than " + std::to_string(kMostRuns) +
           " runs; vary less or use fewer seeds");
  }
  std::string problems;
  for (std::int64_t point = 0; point < points && problems.empty(); ++point) {
    const Params params = design.params_of(point * design.seeds);
    for (const Problem& problem : check(params)) problems += problem.message + "\n";
    if (params.steps <= params.discard) {
      problems += "steps = " + std::to_string(params.steps) +
                  " leaves no step for the means: it must exceed discard = " +
                  std::to_string(params.discard) + "\n";
    }
    if (params.steps < params.flow_lag) {
      problems += "flow_lag = " + std::to_string(params.flow_lag) +
                  " leaves no step with a pup flow: it must be at most steps = " +
                  std::to_string(params.steps) + "\n";
    }
  }
  if (!problems.empty()) refuse(problems);
}

}  // namespace pupflow::study
