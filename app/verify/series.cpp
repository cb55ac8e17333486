// Metrics and pups CSV files, row by row.
#include <optional>

#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/progress.h"
#include "app/io/text.h"
#include "app/verify/kinds.h"
#include "pupflow/observer.h"

namespace pupflow::verify {
namespace {

using Cells = std::vector<std::string>;

std::int64_t number_in(const Cells& row, std::size_t column, const io::CsvReader& file) {
  const auto number = io::read_number<std::int64_t>(row[column]);
  if (!number || *number < 0) {
    io::refuse(file.where() + ": " + file.columns()[column] + " must be a whole number, not " +
               io::quoted(row[column]));
  }
  return *number;
}

/// The first cell in which a row differs from the run's.
std::optional<std::string> compare(const std::string& where, const Cells& columns,
                                   const Cells& file, const Cells& run) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (file[i] != run[i]) return difference(where, columns[i], file[i], run[i]);
  }
  return std::nullopt;
}

std::string at_step(std::int64_t step) {
  return "step " + std::to_string(step);
}

Verdict same(const Simulation& litter, std::int64_t rows) {
  return {true, std::to_string(litter.steps_done()) + " steps, " + std::to_string(rows) + " rows"};
}

/// The step after which the run behind a file began to be observed.
std::int64_t begun(const io::TextEntries& entries) {
  const std::string* step = find_entry(entries, "begun");
  return step ? io::read_number<std::int64_t>(*step).value_or(0) : 0;
}

std::optional<std::string> went_wrong(const Simulation& litter) {
  if (litter.status().ok()) return std::nullopt;
  return "the run goes wrong where the file goes on: " + litter.status().message();
}

}  // namespace

Verdict verify_metrics(const std::string& path, const Options& options) {
  if (options.row) io::refuse(path + ": --row takes a sweep's runs.csv");
  const io::TextEntries entries = io::read_csv_header(path);
  Simulation litter = litter_of(entries, path, options);
  io::CsvReader file(path);
  io::Progress progress("verify", litter.recipe().steps, options.quiet);
  litter.set_observed(ObservableSet::all().parts());
  advance(litter, begun(entries));
  Observer observer(litter);
  std::int64_t rows = 0;
  while (const auto row = file.next()) {
    const std::int64_t step = number_in(*row, 0, file);
    if (step <= litter.steps_done()) {
      io::refuse(file.where() + ": step " + (*row)[0] + " does not follow the row before");
    }
    advance(litter, step, [&] {
      if (litter.steps_done() < step) observer.pass(litter);
      progress.update(litter.steps_done());
    });
    if (const auto wrong = went_wrong(litter)) return {false, *wrong};
    const Cells cells = io::metrics_cells(litter, observer.observe(litter));
    if (const auto other = compare(at_step(step), file.columns(), *row, cells)) {
      return {false, *other};
    }
    ++rows;
  }
  return same(litter, rows);
}

Verdict verify_pups(const std::string& path, const Options& options) {
  if (options.row) io::refuse(path + ": --row takes a sweep's runs.csv");
  Simulation litter = litter_of(io::read_csv_header(path), path, options);
  io::CsvReader file(path);
  io::Progress progress("verify", litter.recipe().steps, options.quiet);
  litter.set_observed(parts_in_files());
  std::vector<Cells> cells;  // of all pups after the step
  std::int64_t rows = 0;
  while (const auto row = file.next()) {
    const std::int64_t step = number_in(*row, 0, file), pup = number_in(*row, 1, file);
    if (step < litter.steps_done() || pup >= litter.pups()) {
      io::refuse(file.where() + ": step " + (*row)[0] + ", pup " + (*row)[1] +
                 " does not follow the row before");
    }
    if (step > litter.steps_done() || cells.empty()) {
      advance(litter, step, [&] { progress.update(litter.steps_done()); });
      if (const auto wrong = went_wrong(litter)) return {false, *wrong};
      cells = io::pups_cells(litter);
    }
    const std::string where = at_step(step) + ", pup " + std::to_string(pup);
    const Cells& run = cells[static_cast<std::size_t>(pup)];
    if (const auto other = compare(where, file.columns(), *row, run)) return {false, *other};
    ++rows;
  }
  return same(litter, rows);
}

}  // namespace pupflow::verify
