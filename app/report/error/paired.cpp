#include "app/report/error/paired.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/io/interrupt.h"
#include "app/io/text.h"
#include "app/report/error/sampling.h"
#include "app/report/share_out.h"
#include "app/report/statistics.h"
#include "pupflow/observer.h"

namespace pupflow::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One change in one run.
struct Cell {
  Status status;
  std::string warnings;  // of the engine, in words
  double seconds = 0;
  std::vector<double> means;  // run_statistics()
  bool good() const { return status.ok(); }
};

/// One run that serves all changes which differ only in the steps of their means.
struct Job {
  Params params;
  std::vector<std::size_t> rows;
};

Params without_window(Params params) {
  params.steps = params.discard = 0;
  return params;
}

std::vector<Job> jobs_of(const std::vector<Compared>& rows) {
  std::vector<Job> jobs;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!rows[row].refused.empty()) continue;
    const Params& params = rows[row].change.params;
    const auto same = std::find_if(jobs.begin(), jobs.end(), [&](const Job& job) {
      return without_window(job.params) == without_window(params);
    });
    if (same == jobs.end()) {
      jobs.push_back({params, {row}});
    } else {
      same->rows.push_back(row);
      same->params.steps = std::max(same->params.steps, params.steps);
      same->params.discard = std::min(same->params.discard, params.discard);
    }
  }
  return jobs;
}

/// Runs a job with one seed and fills `cells`, one for each of its rows.
void run_job(const Job& job, std::int64_t seed, const std::vector<Compared>& rows,
             std::vector<Cell>& cells) {
  Params params = job.params;
  params.seed = seed;
  const double begin = thread_seconds();
  Simulation simulation(params);
  std::optional<Observer> observer;
  std::vector<RunMeans> means;
  for (const std::size_t row : job.rows) means.emplace_back(rows[row].change.params.discard);
  const auto close = [&](std::size_t i) {
    cells[i] = {simulation.status(), warnings_text(simulation.warnings()), thread_seconds() - begin,
                statistics_of(means[i])};
  };
  // As in run_to_end: the first pup flow in the means compares with the step flow_lag before.
  const std::int64_t first = std::max<std::int64_t>(params.discard - params.flow_lag, 0);
  while (simulation.steps_done() < params.steps && !io::interrupted()) {
    if (simulation.steps_done() == first) observer.emplace(simulation);
    if (!simulation.step().ok()) break;
    if (simulation.steps_done() <= params.discard) {
      if (observer) observer->pass(simulation);
      continue;
    }
    const Observables& seen = observer->observe(simulation);
    for (std::size_t i = 0; i < means.size(); ++i) {
      const std::int64_t end = rows[job.rows[i]].change.params.steps;
      if (simulation.steps_done() <= end) means[i].add(simulation, seen);
      if (simulation.steps_done() == end) close(i);
    }
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (cells[i].means.empty()) close(i);  // the run ended early
  }
}

/// Why a change cannot be run or has no means; else empty.
std::string refusal(const Params& params) {
  const std::vector<Problem> problems = check(params);
  if (!problems.empty()) return problems.front().message;
  if (params.steps > params.discard) return "";
  return "no means: discard = " + std::to_string(params.discard) + " leaves out all " +
         std::to_string(params.steps) + " steps";
}

/// Means over good runs, and differences over seeds that are good in both.
void sum_up(const std::vector<Cell>& base, const std::vector<Cell>& own, std::size_t observable,
            Compared& row) {
  std::vector<double> means, differences;
  for (std::size_t seed = 0; seed < own.size(); ++seed) {
    if (!own[seed].good()) continue;
    means.push_back(own[seed].means[observable]);
    if (!base[seed].good()) continue;
    differences.push_back(own[seed].means[observable] - base[seed].means[observable]);
  }
  row.means.push_back(estimate_of(means));
  row.differences.push_back(estimate_of(differences));
}

}  // namespace

std::string Compared::trouble(std::int64_t seeds) const {
  if (!refused.empty()) return refused;
  const std::string of = " of " + std::to_string(seeds) + " runs ";
  std::string text;
  if (bad > 0) text = std::to_string(bad) + of + "failed, the first with " + first_bad.message();
  if (warned > 0) {
    text += (text.empty() ? "" : "; ") + std::to_string(warned) + of +
            "ended with a warning, the first with " + first_warning;
  }
  return text;
}

Paired compare(const PairedWork& work, const Options& options) {
  Paired paired{work.observables, work.seeds, {}};
  for (const Change& change : work.changes) {
    Compared row;
    row.change = change;
    row.refused = refusal(change.params);
    paired.rows.push_back(std::move(row));
  }
  const std::vector<Job> jobs = jobs_of(paired.rows);
  const auto count = static_cast<std::int64_t>(jobs.size());
  const auto seeds = static_cast<std::size_t>(work.seeds);
  std::vector<std::vector<Cell>> cells(paired.rows.size(), std::vector<Cell>(seeds));
  // Seed by seed, so that other work on the machine slows all changes alike.
  share_out(work.name, count * work.seeds, options, [&](std::int64_t i) {
    const Job& job = jobs[static_cast<std::size_t>(i % count)];
    std::vector<Cell> own(job.rows.size());
    run_job(job, work.changes.front().params.seed + i / count, paired.rows, own);
    for (std::size_t k = 0; k < own.size(); ++k) {
      cells[job.rows[k]][static_cast<std::size_t>(i / count)] = std::move(own[k]);
    }
  });
  const std::vector<std::string> names = statistic_names();
  for (std::size_t r = 0; r < paired.rows.size(); ++r) {
    Compared& row = paired.rows[r];
    if (!row.refused.empty()) {
      row.means.assign(work.observables.size(), {kNone, kNone});
      row.differences = row.means;
      continue;
    }
    for (const Cell& cell : cells[r]) {
      row.seconds += cell.seconds;
      if (!cell.warnings.empty() && row.warned++ == 0) row.first_warning = cell.warnings;
      if (cell.good()) continue;
      if (row.bad++ == 0) row.first_bad = cell.status;
    }
    for (const std::string& wanted : work.observables) {
      const auto at = std::find(names.begin(), names.end(), wanted);
      sum_up(cells[0], cells[r], static_cast<std::size_t>(at - names.begin()), row);
    }
  }
  return paired;
}

}  // namespace pupflow::report
