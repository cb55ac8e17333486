#include "app/report/error/own_run.h"

#include <algorithm>
#include <cmath>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "app/report/error/paired.h"
#include "app/report/statistics.h"

namespace pupflow::report {
namespace {

void check_run(const OwnRun& run, std::int64_t seeds) {
  const Params& p = run.params;
  if (p.pups == 0) io::refuse("pups = 0: there are no means without pups; pups must be at least 1");
  if (p.discard >= p.steps) {
    io::refuse("discard = " + std::to_string(p.discard) + " leaves out all " +
               std::to_string(p.steps) +
               " steps, so there are no means; discard must be below steps");
  }
  Params last = p;
  last.seed += seeds - 1;
  if (!check(last).empty()) {
    io::refuse("seed = " + std::to_string(p.seed) + ": the last of " + std::to_string(seeds) +
               " seeds would be too large; choose a lower seed");
  }
  const std::vector<std::string> names = statistic_names();
  for (const std::string& wanted : run.observables) {
    if (std::find(names.begin(), names.end(), wanted) != names.end()) continue;
    std::string listed;
    for (const std::string& name : names) listed += (listed.empty() ? "" : ", ") + name;
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string meant = io::did_you_mean(wanted, views);
    io::refuse("--observable: unknown " + io::quoted(wanted) +
               (meant.empty() ? "; there are " + listed : meant));
  }
}

std::string seeds_words(std::int64_t seeds) {
  return std::to_string(seeds) + (seeds == 1 ? " seed" : " seeds");
}

/// The effect on an observable of the change for which `wanted` is true; `what` names that change.
template <class Wanted>
std::string change_words(const Paired& paired, std::size_t observable, const std::string& what,
                         Wanted wanted) {
  const auto row = std::find_if(paired.rows.begin() + 1, paired.rows.end(),
                                [&](const Compared& r) { return wanted(r.change.params); });
  if (row == paired.rows.end()) return "";
  if (!row->refused.empty()) return " " + what + " is refused: " + row->refused + ".";
  const Estimate& change = row->differences[observable];
  if (!std::isfinite(change.interval)) return " " + what + ": " + row->trouble(paired.seeds) + ".";
  return " " + what + " changes it by " + words_of(change, true) + ", " +
         (change.beyond_chance() ? "more than" : "within") + " its interval.";
}

/// The interval of one observable, and what it would be for half and twice the time.
std::string answer(const Paired& paired, std::size_t observable) {
  const Compared& base = paired.rows.front();
  const std::string& name = paired.observables[observable];
  const Estimate& mean = base.means[observable];
  const std::int64_t good = paired.seeds - base.bad;
  if (good < 2) return name + ": no interval; " + base.trouble(paired.seeds) + ".";
  std::string text = name + " " + words_of(mean) + " (95 %, " + seeds_words(good) + ", " +
                     rounded(base.seconds) + " CPU s).";
  if (mean.interval == 0) {
    text += " All seeds give the same value, so more seeds do not change it.";
  } else {
    const auto with = [&](std::int64_t seeds) {
      return seeds_words(seeds) +
             (seeds < 2 ? ", no interval"
                        : ", ± " + rounded(interval_with(paired, observable, seeds), 2));
    };
    text += " Half the time: " + with(good / 2) + "; twice the time: " + with(2 * good) + ".";
  }
  if (base.bad > 0) text += " " + base.trouble(paired.seeds) + ".";
  const Params& own = base.change.params;
  return text +
         change_words(paired, observable, "Halving dt",
                      [&](const Params& p) {
                        return p.dt == own.dt / 2 && p.refinement == own.refinement;
                      }) +
         change_words(paired, observable, "Running twice the steps", [&](const Params& p) {
           return p.dt == own.dt && p.steps == 2 * own.steps && p.discard == own.discard;
         });
}

std::string guide(const Paired& paired) {
  return "Every row has the same " + seeds_words(paired.seeds) + ". " + how_to_read() +
         " With `naive` another step means another body, harder or softer; "
         "`consistent` keeps the body (docs/numerics.md, Time step and refinement).";
}

}  // namespace

OwnAnswer report_own_error(const Options& options, const OwnRun& run) {
  const std::int64_t seeds = run.seeds > 0 ? run.seeds : options.quick ? 5 : 20;
  check_run(run, seeds);
  PairedWork work{"error", changes_of(run.params, 2), seeds, run.observables};
  if (work.observables.empty())
    work.observables = {statistic_name(Observable::huddling), statistic_name(Observable::mean_tb)};
  Report report(options, "The error of this run" + (run.title.empty() ? "" : ": " + run.title));
  const Paired paired = compare(work, options);
  OwnAnswer result;
  for (std::size_t i = 0; i < paired.observables.size(); ++i) {
    const std::string line = answer(paired, i);
    result.words += line + "\n";
    report.text("**" + line + "**");
  }
  report.heading("What each choice changes");
  report.text(guide(paired));
  show(report, "paired", "Size of each change against processor seconds, with its 95 % interval",
       paired);
  report.finish();
  const Compared& base = paired.rows.front();
  if (base.bad > 0) result.failures = base.trouble(paired.seeds);
  return result;
}

}  // namespace pupflow::report
