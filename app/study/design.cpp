#include "app/study/design.h"

#include <set>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/text.h"
#include "pupflow/ensemble.h"

namespace pupflow::study {
namespace {

constexpr std::int64_t kMostRuns = 100'000'000, kMostShards = 1'000'000;
constexpr std::int64_t kMostSeries = 100'000, kMostSamples = 1'000'000;

using io::refuse;

}  // namespace

Shard parse_shard(const std::string& text, const std::string& where) {
  const auto parts = io::split(text, '/');
  Shard shard{0, 0};
  if (parts.size() == 2) {
    shard.number = io::read_number<std::int64_t>(parts[0]).value_or(0);
    shard.of = io::read_number<std::int64_t>(parts[1]).value_or(0);
  }
  if (shard.number < 1 || shard.number > shard.of || shard.of > kMostShards) {
    refuse(where + " " + io::quoted(text) + ": write i/n with i from 1 to n, e.g. 1/4");
  }
  return shard;
}

std::int64_t Design::points() const {
  if (!given_seeds.empty()) return static_cast<std::int64_t>(given_seeds.size());
  if (layout != Layout::grid) {
    return axes.empty() ? 0 : static_cast<std::int64_t>(axes[0].values.size());
  }
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
    const std::int64_t place = layout == Layout::grid ? point % size : point;
    values[a] = axes[a].values[static_cast<std::size_t>(place)];
    if (layout == Layout::grid) point /= size;
  }
  return values;
}

std::int64_t Design::number_of(std::int64_t run) const {
  const std::int64_t point = run / seeds, seed = run % seeds;
  const std::int64_t block = seed / seed_block, place = seed % seed_block;
  return (block * points() + point) * seed_block + place;
}

std::optional<std::int64_t> Design::run_of(std::int64_t number) const {
  if (number < 0) return std::nullopt;
  const std::int64_t block = number / seed_block / points(), point = number / seed_block % points();
  const std::int64_t seed = block * seed_block + number % seed_block;
  if (seed >= seeds) return std::nullopt;
  return point * seeds + seed;
}

std::int64_t Design::seed_of(std::int64_t run) const {
  if (!given_seeds.empty()) return given_seeds[static_cast<std::size_t>(run)];
  return run_seed(base.seed, number_of(run));
}

Params Design::params_of(std::int64_t run) const {
  Params params = base;
  const std::vector<double> values = values_at(run / seeds);
  for (std::size_t a = 0; a < axes.size(); ++a) axes[a].parameter->set(params, values[a]);
  params.seed = seed_of(run);
  return params;
}

std::vector<std::int64_t> Design::own_runs() const {
  std::vector<std::int64_t> own(static_cast<std::size_t>(own_count()));
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = own_run(static_cast<std::int64_t>(i));
  return own;
}

std::vector<std::string> run_problems(const Params& params) {
  std::vector<std::string> problems;
  for (const Problem& problem : check(params)) problems.push_back(problem.message);
  if (params.steps <= params.discard) {
    problems.push_back("steps = " + std::to_string(params.steps) +
                       " leaves no step for the means: it must exceed discard = " +
                       std::to_string(params.discard));
  }
  if (params.steps < params.flow_lag) {
    problems.push_back("flow_lag = " + std::to_string(params.flow_lag) +
                       " leaves no step with a pup flow: it must be at most steps = " +
                       std::to_string(params.steps));
  }
  return problems;
}

namespace {

/// Refuses series that would fill a disk or a folder.
void check_series(const Design& design, const Params& params) {
  if (design.record_every == 0) return;
  if (design.runs() > kMostSeries)
    refuse("--record: " + std::to_string(design.runs()) + " runs are more files than the " +
           std::to_string(kMostSeries) + " that one folder may hold; record a smaller sweep");
  if (params.steps / design.record_every > kMostSamples)
    refuse("--record: a series of " + std::to_string(params.steps / design.record_every) +
           " rows is longer than " + std::to_string(kMostSamples) + "; give a larger --every");
}

}  // namespace

void check_design(const Design& design) {
  std::set<const Parameter*> seen;
  for (const Axis& axis : design.axes) {
    if (!seen.insert(axis.parameter).second) {
      refuse("--vary " + std::string(axis.parameter->name) + " is given twice");
    }
  }
  if (!design.given_seeds.empty() && design.seeds != 1)
    refuse("a table that gives the seed of each run has one run a row, not " +
           std::to_string(design.seeds));
  const std::int64_t points = design.points();
  // The block is no number of runs, but numbers of runs are multiples of it.
  if (points > kMostRuns || design.seeds > kMostRuns || design.runs() > kMostRuns ||
      design.seed_block > kMostRuns) {
    refuse("the sweep has more than " + std::to_string(kMostRuns) +
           " runs; vary less or use fewer seeds");
  }
  if (points < 1) refuse("the sweep has no runs; say what varies");
  for (std::int64_t point = 0; point < points; ++point) {
    if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
    const Params params = design.params_of(point * design.seeds);
    const std::vector<std::string> problems = run_problems(params);
    io::refuse_all(problems);
    check_series(design, params);
  }
}

}  // namespace pupflow::study
