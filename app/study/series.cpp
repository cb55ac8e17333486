#include "app/study/series.h"

#include <algorithm>
#include <filesystem>

#include "app/io/atomic_file.h"
#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/study/files.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSeries = std::size_t{1} << 30;

/// Whether it is a name that series_path makes.
bool is_series(const std::string& name) {
  constexpr std::string_view kEnding = ".csv";
  if (!name.ends_with(kEnding)) return false;
  const auto parts = io::split(std::string_view(name).substr(0, name.size() - kEnding.size()), '-');
  return parts.size() == 2 && std::all_of(parts.begin(), parts.end(), [](std::string_view part) {
           return io::read_number<std::uint64_t>(part).has_value();
         });
}

void make_series_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directory(series_folder(folder), error);
  if (error) {
    throw io::Failure(io::ExitCode::bad_file,
                      series_folder(folder) + ": cannot make this folder: " + error.message());
  }
}

}  // namespace

std::string series_path(const std::string& folder, const Design& design, std::int64_t run) {
  return series_folder(folder) + "/" + std::to_string(run / design.seeds + 1) + "-" +
         std::to_string(run % design.seeds + 1) + ".csv";
}

bool has_series(const std::string& folder, const Design& design, std::int64_t run) {
  return design.record_every == 0 || fs::exists(series_path(folder, design, run));
}

bool has_all_series(const std::string& folder, const Design& design) {
  const std::vector<std::int64_t> runs = design.own_runs();
  return design.record_every == 0 || std::all_of(runs.begin(), runs.end(), [&](std::int64_t run) {
           return has_series(folder, design, run);
         });
}

void write_series(const std::string& folder, const Design& design, std::int64_t run,
                  const RunResult& result) {
  if (design.record_every == 0) return;
  make_series_folder(folder);
  const Params params = design.params_of(run);
  const std::string path = series_path(folder, design, run);
  refuse_no_file(path);
  io::CsvFile csv(path, true, io::provenance(params), io::joined(io::metrics_columns(), ","));
  for (const Sample& sample : result.series) {
    csv.row(io::metrics_cells(sample.step, sample.time, sample.seen));
  }
  csv.comment("step = " + std::to_string(result.steps));
  csv.comment("hash = " + io::hash_text(result.hash));
  for (const Warning& warning : result.warnings.all()) csv.comment("warning: " + warning.message());
  if (!result.status.ok()) csv.comment("ended early: " + result.status.message());
  csv.commit();
}

void copy_series(const std::string& from, const Design& shard, const std::string& to) {
  if (shard.record_every == 0) return;
  make_series_folder(to);
  for (const std::int64_t run : shard.own_runs()) {
    const std::string path = series_path(to, shard, run);
    refuse_no_file(path);
    io::AtomicFile copy(path, true);
    copy.write(io::read_file(series_path(from, shard, run), kLargestSeries));
    copy.commit();
  }
}

void remove_series(const std::string& folder) {
  std::error_code error;
  if (fs::is_symlink(series_folder(folder), error)) return;  // its files are not this sweep's
  for (const auto& entry : fs::directory_iterator(series_folder(folder), error)) {
    if (!is_series(entry.path().filename().string())) continue;
    if (!fs::remove(entry.path(), error) && error) {
      throw io::Failure(io::ExitCode::bad_file,
                        entry.path().string() + ": cannot remove: " + error.message());
    }
  }
  fs::remove(series_folder(folder), error);  // stays when something else is in it
}

}  // namespace pupflow::study
