#include "app/study/sweep.h"

#include <algorithm>
#include <filesystem>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/note.h"
#include "app/io/progress.h"
#include "app/study/files.h"
#include "app/study/folder.h"
#include "app/study/journal.h"
#include "app/study/lock.h"
#include "app/study/plot.h"
#include "app/study/series.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

/// The own runs that are not finished: without a row in the journal, or without their series.
std::vector<std::int64_t> missing_runs(const SweepJob& job, const Journal& journal) {
  std::vector<std::int64_t> missing;
  for (const std::int64_t run : job.design.own_runs()) {
    if (!journal.rows().contains(run) || !has_series(job.folder, job.design, run))
      missing.push_back(run);
  }
  return missing;
}

void tell_of_damage(const Journal& journal, const std::string& path) {
  if (journal.damaged() == 0) return;
  const bool one = journal.damaged() == 1;
  io::note(std::to_string(journal.damaged()) + " damaged row" + (one ? "" : "s") + " of " + path +
           (one ? " is" : " are") + " computed again");
}

void compute(const SweepJob& job, const std::vector<std::int64_t>& missing, Journal& journal) {
  const auto total = static_cast<std::int64_t>(missing.size());
  io::Progress progress(job.design.name + ": runs", total, job.quiet);
  std::int64_t done = 0;
  const auto params_of = [&](std::int64_t i) {
    return job.design.params_of(missing[static_cast<std::size_t>(i)]);
  };
  const auto deliver = [&](std::int64_t i, const RunResult& result) {
    const std::int64_t run = missing[static_cast<std::size_t>(i)];
    write_series(job.folder, job.design, run, result);
    journal.add(make_row(run, result));
    progress.update(++done);
  };
  const std::int64_t every = job.design.record_every;
  if (job.executor) {
    job.executor->compute(total, params_of, deliver, io::interrupted, every);
  } else {
    run_ensemble(total, job.threads, params_of, deliver, io::interrupted, every);
  }
  if (done < total) {
    const std::int64_t own = static_cast<std::int64_t>(job.design.own_runs().size());
    throw io::Failure(io::ExitCode::interrupted,
                      "interrupted with " + std::to_string(own - total + done) + " of " +
                          std::to_string(own) +
                          " runs finished; the same command computes the others");
  }
}

}  // namespace

SweepResult write_results(const std::string& folder, const Design& design, std::vector<Row> rows,
                          const std::string& plot_script) {
  SweepResult result;
  result.rows = std::move(rows);
  write_runs(runs_path(folder), design, result.rows);
  if (!design.shard.whole()) {
    result.note = "this is shard " + std::to_string(design.shard.number) + " of " +
                  std::to_string(design.shard.of) + "; 'pupflow merge' joins them";
    return result;
  }
  result.summaries = summarise(design, result.rows);
  write_summary(summary_path(folder), design, result.summaries);
  result.note = draw_plots(folder, design, result.summaries, plot_script);
  return result;
}

SweepResult run_sweep(const SweepJob& job) {
  check_design(job.design);
  const FolderLock lock(job.folder);
  claim_folder(job.folder, job.design, job.force);
  remove_leftovers(job.folder, job.design);
  std::vector<Row> rows;
  std::int64_t computed = 0;
  if (fs::exists(runs_path(job.folder))) rows = read_runs(runs_path(job.folder), job.design);
  if (rows.empty() || !has_all_series(job.folder, job.design)) {
    Journal journal(journal_path(job.folder), job.design);
    tell_of_damage(journal, journal_path(job.folder));
    for (const Row& row : rows) journal.add(row);
    const std::vector<std::int64_t> missing = missing_runs(job, journal);
    computed = static_cast<std::int64_t>(missing.size());
    compute(job, missing, journal);
    rows.clear();
    for (const std::int64_t run : job.design.own_runs()) rows.push_back(journal.rows().at(run));
  }
  if (job.executor) job.executor->release();
  const std::int64_t resumed = static_cast<std::int64_t>(rows.size()) - computed;
  SweepResult result = write_results(job.folder, job.design, std::move(rows), job.plot_script);
  result.resumed = resumed;
  std::error_code ignored;  // a journal left behind is harmless: runs.csv has its rows
  fs::remove(journal_path(job.folder), ignored);
  return result;
}

namespace {

/// How many rows are `odd`, and the first of them; empty when there is none.
std::string count_text(const Design& design, const std::vector<Row>& rows, const char* what,
                       bool (*odd)(const Row&)) {
  const auto first = std::find_if(rows.begin(), rows.end(), odd);
  if (first == rows.end()) return {};
  return std::to_string(std::count_if(first, rows.end(), odd)) + " of " +
         std::to_string(rows.size()) + " runs " + what + "; the first, run " +
         std::to_string(first->run) + " (seed " + std::to_string(design.seed_of(first->run)) +
         "): " + first->status;
}

}  // namespace

std::string failures_text(const Design& design, const std::vector<Row>& rows) {
  return count_text(design, rows, "failed and are not in the means",
                    [](const Row& row) { return !row.fine(); });
}

std::string warnings_text(const Design& design, const std::vector<Row>& rows) {
  return count_text(design, rows, "ended with a warning and are in the means",
                    [](const Row& row) { return row.warned(); });
}

}  // namespace pupflow::study
