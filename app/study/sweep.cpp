#include "app/study/sweep.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/io/read_file.h"
#include "app/study/journal.h"
#include "app/study/plot.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestManifest = std::size_t{1} << 26;

[[noreturn]] void refuse(const std::string& message) {
  throw io::Failure(io::ExitCode::bad_input, message);
}

void write_file(const std::string& path, const std::string& text) {
  io::AtomicFile file(path, true);
  file.write(text);
  file.commit();
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw io::Failure(io::ExitCode::bad_file,
                      folder + ": cannot make this folder: " + error.message());
  }
}

/// The first line in which two manifests differ, for people.
std::string difference(const std::string& there, const std::string& now) {
  std::istringstream a(there), b(now);
  std::string line_a, line_b;
  while (true) {
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (!more_a && !more_b) return "nothing";
    if (!more_a || !more_b || line_a != line_b) {
      return "'" + (more_a ? line_a : "") + "' there, '" + (more_b ? line_b : "") + "' now";
    }
  }
}

/// Makes sure that the folder is this sweep's; a new or forced one starts with its manifest.
void claim_folder(const SweepJob& job) {
  make_folder(job.folder);
  const std::string text = manifest_text(job.design), path = manifest_path(job.folder);
  const bool claimed = fs::exists(path);
  if (claimed && !job.force) {
    const std::string there = io::read_file(path, kLargestManifest);
    if (there == text) return;
    refuse(job.folder + ": holds another sweep: " + difference(there, text) +
           "; name another folder with --out, or use --force to start afresh");
  }
  if (claimed && io::read_file(path, kLargestManifest) == text)
    return;  // forced, but the same: go on
  for (const std::string& file :
       {runs_path(job.folder), summary_path(job.folder), journal_path(job.folder)}) {
    if (!fs::exists(file)) continue;
    if (!job.force)
      refuse(file + ": exists, but no manifest says of which sweep; use --force to start afresh");
    std::error_code error;
    if (!fs::remove(file, error)) {
      throw io::Failure(io::ExitCode::bad_file, file + ": cannot remove: " + error.message());
    }
  }
  write_file(path, text);
}

/// Computes the own runs that the journal lacks.
void compute(const SweepJob& job, Journal& journal) {
  std::vector<std::int64_t> missing;
  for (const std::int64_t run : job.design.own_runs()) {
    if (!journal.rows().contains(run)) missing.push_back(run);
  }
  const auto total = static_cast<std::int64_t>(missing.size());
  io::Progress progress(job.design.name + ": runs", total, job.quiet);
  std::int64_t done = 0;
  run_ensemble(
      total, job.threads,
      [&](std::int64_t i) { return job.design.params_of(missing[static_cast<std::size_t>(i)]); },
      [&](std::int64_t i, const RunResult& result) {
        journal.add(make_row(missing[static_cast<std::size_t>(i)], result));
        progress.update(++done);
      },
      io::interrupted);
  if (done < total) {
    const std::int64_t own = static_cast<std::int64_t>(job.design.own_runs().size());
    throw io::Failure(io::ExitCode::interrupted,
                      "interrupted with " + std::to_string(own - total + done) + " of " +
                          std::to_string(own) +
                          " runs finished; the same command goes on from there");
  }
}

/// Writes everything that follows from the rows.
void write_results(const std::string& folder, const Design& design, SweepResult& result) {
  write_runs(runs_path(folder), design, result.rows);
  if (!design.shard.whole()) {
    result.note = "this is shard " + std::to_string(design.shard.number) + " of " +
                  std::to_string(design.shard.of) + "; 'pupflow merge' joins them";
    return;
  }
  result.summaries = summarise(design, result.rows);
  write_summary(summary_path(folder), design, result.summaries);
  result.note = draw_plots(folder, design);
}

/// A shard's folder, read.
struct Part {
  Design design;
  std::vector<Row> rows;
};

Part read_part(const std::string& folder) {
  Part part;
  part.design = design_of_folder(folder);
  if (fs::exists(journal_path(folder)) && !fs::exists(runs_path(folder))) {
    refuse(folder + ": is not finished; run its command again first");
  }
  part.rows = read_runs(runs_path(folder), part.design);
  return part;
}

}  // namespace

Design design_of_folder(const std::string& folder) {
  const std::string path = manifest_path(folder);
  return parse_manifest(io::read_file(path, kLargestManifest), path);
}

std::string runs_path(const std::string& folder) {
  return folder + "/runs.csv";
}
std::string summary_path(const std::string& folder) {
  return folder + "/summary.csv";
}
std::string manifest_path(const std::string& folder) {
  return folder + "/manifest.toml";
}
std::string journal_path(const std::string& folder) {
  return folder + "/journal.csv";
}

SweepResult run_sweep(const SweepJob& job) {
  check_design(job.design);
  claim_folder(job);
  SweepResult result;
  if (fs::exists(runs_path(job.folder))) {
    result.rows = read_runs(runs_path(job.folder), job.design);
    result.resumed = static_cast<std::int64_t>(result.rows.size());
  } else {
    Journal journal(journal_path(job.folder), job.design);
    result.resumed = static_cast<std::int64_t>(journal.rows().size());
    compute(job, journal);
    for (const std::int64_t run : job.design.own_runs())
      result.rows.push_back(journal.rows().at(run));
  }
  write_results(job.folder, job.design, result);
  std::error_code ignored;  // a journal left behind is harmless: runs.csv has its rows
  fs::remove(journal_path(job.folder), ignored);
  return result;
}

SweepResult merge_shards(const std::vector<std::string>& folders, const std::string& folder,
                         bool force) {
  std::optional<Design> whole;
  std::vector<Row> rows;
  std::vector<std::string> holder;  // which folder holds shard number i + 1
  for (const std::string& from : folders) {
    Part part = read_part(from);
    const Shard shard = part.design.shard;
    part.design.shard = {};
    if (!whole) {
      whole = part.design;
      holder.resize(static_cast<std::size_t>(shard.of));
      rows.resize(static_cast<std::size_t>(whole->runs()));
    }
    if (manifest_text(part.design) != manifest_text(*whole)) {
      refuse(from + ": belongs to another sweep than " + folders[0] + ": " +
             difference(manifest_text(*whole), manifest_text(part.design)));
    }
    if (static_cast<std::size_t>(shard.of) != holder.size()) {
      refuse(from + ": is one of " + std::to_string(shard.of) + " shards, " + folders[0] +
             " one of " + std::to_string(holder.size()));
    }
    std::string& taken = holder[static_cast<std::size_t>(shard.number - 1)];
    if (!taken.empty()) {
      refuse(from + ": is shard " + std::to_string(shard.number) + ", and so is " + taken);
    }
    taken = from;
    for (Row& row : part.rows) rows[static_cast<std::size_t>(row.run)] = std::move(row);
  }
  if (!whole) refuse("no shards to merge: name their folders");
  std::string missing;
  for (std::size_t i = 0; i < holder.size(); ++i) {
    if (holder[i].empty()) missing += " " + std::to_string(i + 1);
  }
  if (!missing.empty())
    refuse("these shards of " + std::to_string(holder.size()) + " are missing:" + missing);
  SweepJob job;
  job.design = *whole;
  job.folder = folder;
  job.force = force;
  claim_folder(job);
  SweepResult result;
  result.rows = std::move(rows);
  write_results(folder, *whole, result);
  return result;
}

std::string failures_text(const Design& design, const std::vector<Row>& rows) {
  const auto bad =
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.fine(); });
  if (bad == 0) return {};
  const auto first =
      std::find_if(rows.begin(), rows.end(), [](const Row& row) { return !row.fine(); });
  return std::to_string(bad) + " of " + std::to_string(rows.size()) +
         " runs went wrong and are left out of the means; the first, run " +
         std::to_string(first->run) + " (seed " +
         std::to_string(run_seed(design.base.seed, first->run)) + "): " + first->status;
}

}  // namespace pupflow::study
