// Metrics and pups CSV files, row by row.
#include <optional>
#include <utility>

#include "app/io/atomic_file.h"
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

/// The steps that a file reports. A run reports those that `every` divides, for some `every`.
class ReportedSteps {
 public:
  explicit ReportedSteps(std::int64_t begun) : begun_(begun), last_(begun) {}

  /// Takes the next one; says which are missing before it.
  std::optional<std::string> take(std::int64_t step) {
    if (every_ == 0 && (begun_ == 0 || last_ != begun_)) every_ = step - last_;
    const std::int64_t before = std::exchange(last_, step);
    if (every_ == 0 || step == (before / every_ + 1) * every_) return std::nullopt;
    return "the rows between " + at_step(before) + " and " + at_step(step) + " are missing";
  }

  /// Says whether some are missing up to `end`, the last step of the run.
  std::optional<std::string> end_at(std::int64_t end) const {
    if (every_ == 0 || end - last_ < every_) return std::nullopt;
    return "the rows after " + at_step(last_) + " are missing";
  }

 private:
  std::int64_t begun_, last_;
  std::int64_t every_ = 0;  // 0: not known yet
};

std::optional<std::string> went_wrong(const Simulation& litter) {
  if (litter.status().ok()) return std::nullopt;
  return "the run goes wrong where the file goes on: " + litter.status().message();
}

/// After its rows a file has the run's last step, and the hash of the state then.
Verdict compare_end(const std::string& path, const io::CsvReader& file, const ReportedSteps& steps,
                    Simulation& litter, std::int64_t rows) {
  std::optional<std::int64_t> end;
  std::string hash;
  for (const std::string& remark : file.remarks()) {
    if (remark.starts_with("step = ")) end = io::read_number<std::int64_t>(remark.substr(7));
    if (remark.starts_with("hash = ")) hash = remark.substr(7);
  }
  const Verdict same{true, std::to_string(end.value_or(litter.steps_done())) + " steps, " +
                               std::to_string(rows) + " rows"};
  if (!end && hash.empty() && path.ends_with(io::kUnfinished)) return same;
  if (!end || hash.empty()) {
    return {false, "the file ends after " + at_step(litter.steps_done()) +
                       ": its last lines, '# step' and '# hash', are missing"};
  }
  if (*end < litter.steps_done()) {
    return {false, "the file has rows after its last " + at_step(*end)};
  }
  if (const auto missing = steps.end_at(*end)) return {false, *missing};
  advance(litter, *end);
  const Verdict last = compare_hash(litter, hash);
  return last.same ? same : last;
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
  ReportedSteps steps(litter.steps_done());
  Observer observer(litter);
  std::int64_t rows = 0;
  while (const auto row = file.next()) {
    const std::int64_t step = number_in(*row, 0, file);
    if (step <= litter.steps_done()) {
      io::refuse(file.where() + ": step " + (*row)[0] + " does not follow the row before");
    }
    if (const auto missing = steps.take(step)) return {false, *missing};
    advance(litter, step, [&] {
      if (litter.steps_done() < step) observer.pass(litter);
      progress.update(litter.steps_done());
    });
    if (const auto wrong = went_wrong(litter)) return {false, *wrong};
    const Cells cells = io::metrics_cells(step, litter.time(), observer.observe(litter));
    if (const auto other = compare(at_step(step), file.columns(), *row, cells)) {
      return {false, *other};
    }
    ++rows;
  }
  return compare_end(path, file, steps, litter, rows);
}

Verdict verify_pups(const std::string& path, const Options& options) {
  if (options.row) io::refuse(path + ": --row takes a sweep's runs.csv");
  const io::TextEntries entries = io::read_csv_header(path);
  Simulation litter = litter_of(entries, path, options);
  io::CsvReader file(path);
  io::Progress progress("verify", litter.recipe().steps, options.quiet);
  litter.set_observed(parts_in_files());
  ReportedSteps steps(begun(entries));
  std::vector<Cells> cells;  // of all pups after the step
  std::int64_t rows = 0, of_step = 0;
  const std::int64_t pups = litter.pups();
  while (const auto row = file.next()) {
    const std::int64_t step = number_in(*row, 0, file), pup = number_in(*row, 1, file);
    if (step < litter.steps_done() || pup >= litter.pups()) {
      io::refuse(file.where() + ": step " + (*row)[0] + ", pup " + (*row)[1] +
                 " does not follow the row before");
    }
    const bool next = cells.empty() || step > litter.steps_done();
    if (next != (of_step == 0 || of_step == pups) || pup != (next ? 0 : of_step)) {
      return {false, "a row of a pup is missing, or there twice, before " + at_step(step) +
                         ", pup " + std::to_string(pup)};
    }
    of_step = pup + 1;
    if (next) {
      if (const auto missing = steps.take(step)) return {false, *missing};
      advance(litter, step, [&] { progress.update(litter.steps_done()); });
      if (const auto wrong = went_wrong(litter)) return {false, *wrong};
      cells = io::pups_cells(litter);
    }
    const std::string where = at_step(step) + ", pup " + std::to_string(pup);
    const Cells& run = cells[static_cast<std::size_t>(pup)];
    if (const auto other = compare(where, file.columns(), *row, run)) return {false, *other};
    ++rows;
  }
  if (of_step != 0 && of_step != pups && !path.ends_with(io::kUnfinished)) {
    return {false, "rows of " + at_step(litter.steps_done()) + " are missing"};
  }
  return compare_end(path, file, steps, litter, rows);
}

}  // namespace pupflow::verify
