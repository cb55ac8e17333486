// Tables of runs, as a sweep writes them.
#include <algorithm>
#include <mutex>

#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/params_of_file.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/study/design.h"
#include "app/study/results.h"
#include "app/verify/kinds.h"
#include "pupflow/ensemble.h"

namespace pupflow::verify {
namespace {

using Cells = std::vector<std::string>;

struct Table {
  Params base;
  Cells columns;
  std::vector<Cells> rows;
  std::int64_t first = 1;                // the number of the first of them
  std::optional<std::int64_t> complete;  // how many its sweep has
};

Table read_table(const std::string& path, const Options& options) {
  io::CsvReader file(path);
  const io::TextEntries header = io::read_csv_header(path);
  Table table{io::params_from(header, path), file.columns(), {}, 1, {}};
  const std::string *runs = find_entry(header, "runs"), *shard = find_entry(header, "shard");
  if (runs && shard && !options.row) {
    const auto all = io::read_number<std::int64_t>(*runs);
    if (all) table.complete = study::parse_shard(*shard, path + ": shard").count(*all);
  }
  std::int64_t number = 0;
  while (auto row = file.next()) {
    ++number;
    if (options.row && number != *options.row) continue;
    table.rows.push_back(std::move(*row));
  }
  if (options.row) table.first = *options.row;
  if (options.row && table.rows.empty()) {
    io::refuse(path + ": has " + std::to_string(number) + " rows; --row " +
               std::to_string(*options.row) + " is not among them");
  }
  return table;
}

/// The parameters of a row: those of the header, but for the columns that name one.
Params params_of(const Table& table, std::size_t row, const std::string& path) {
  Params params = table.base;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Parameter* parameter = find_parameter(table.columns[i]);
    Problem problem;
    if (parameter && !parse_value(*parameter, table.rows[row][i], params, problem)) {
      io::refuse(path + ": row " + std::to_string(table.first + static_cast<std::int64_t>(row)) +
                 ": " + problem.message);
    }
  }
  return params;
}

/// What the run has in a column; nothing for a column that says what was run.
std::optional<std::string> cell_of(const study::Row& run, const std::string& column) {
  if (column == "status") return run.status;
  const auto fields = run_statistics();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == column) return io::number_text(study::statistic(run, i));
  }
  return std::nullopt;
}

/// Where a row and its run differ; empty where they do not.
std::string compare(const Table& table, std::size_t row, const RunResult& result) {
  const study::Row run = study::make_row(0, result);
  const std::string where = "row " + std::to_string(table.first + static_cast<std::int64_t>(row));
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::optional<std::string> cell = cell_of(run, table.columns[i]);
    if (cell && *cell != table.rows[row][i]) {
      return difference(where, table.columns[i], table.rows[row][i], *cell);
    }
  }
  return {};
}

}  // namespace

Verdict verify_runs(const std::string& path, const Options& options) {
  const Table table = read_table(path, options);
  const auto count = static_cast<std::int64_t>(table.rows.size());
  io::Progress progress("verify", count, options.quiet);
  std::vector<std::string> differences(table.rows.size());
  std::int64_t done = 0;
  run_ensemble(
      count, options.threads,
      [&](std::int64_t row) { return params_of(table, static_cast<std::size_t>(row), path); },
      [&](std::int64_t row, const RunResult& result) {
        const auto place = static_cast<std::size_t>(row);
        differences[place] = compare(table, place, result);
        progress.update(++done);
      },
      io::interrupted);
  if (io::interrupted()) {
    throw io::Failure(io::ExitCode::interrupted,
                      "interrupted after " + std::to_string(done) + " runs");
  }
  for (const std::string& difference : differences) {
    if (!difference.empty()) return {false, difference};
  }
  if (table.complete && count != *table.complete) {
    return {false, "the file has " + std::to_string(count) + " runs, its sweep " +
                       std::to_string(*table.complete)};
  }
  return {true, std::to_string(count) + " runs"};
}

}  // namespace pupflow::verify
