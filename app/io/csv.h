// CSV files: a header of "# name = value" lines that tells how to make the file again, one line of
// column names, then rows. Numbers are written in the shortest form that reads back to the same
// value.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/png.h"
#include "pupflow/fields.h"
#include "pupflow/simulation.h"
#include "pupflow/view.h"

namespace pupflow::io {

/// One CSV file being written; appears whole or not at all. Members throw Failure(bad_file).
class CsvFile {
 public:
  /// Writes the header lines and `columns` (names joined by commas).
  CsvFile(const std::string& path, bool force, const TextEntries& header, std::string_view columns);

  /// One cell of the current row.
  CsvFile& cell(double value);
  CsvFile& cell(std::int64_t value);
  CsvFile& cell(std::string_view words);  // without commas, quotes and line ends
  void end_row();

  /// A whole row.
  void row(const std::vector<std::string>& cells);

  /// A comment line, "# text".
  void comment(std::string_view text);

  /// Puts the file in its place.
  void commit() { file_.commit(); }

 private:
  void add(std::string_view text);

  AtomicFile file_;
  std::string row_;
};

/// The state after each reported step: one row for the whole litter, with all observables.
class MetricsCsv {
 public:
  MetricsCsv(const std::string& path, bool force, const Simulation& start);
  void add(const LitterView& litter, const Observables& seen);
  CsvFile& file() { return file_; }

 private:
  CsvFile file_;
};

/// The state after each reported step: one row for each pup, with its centre and all pup fields
/// that go into files (LitterField::in_files).
class PupsCsv {
 public:
  PupsCsv(const std::string& path, bool force, const Simulation& start);
  void add(const LitterView& litter);
  CsvFile& file() { return file_; }

 private:
  CsvFile file_;
};

/// The columns of either, and the cells of a row, or of the rows of all pups.
std::vector<std::string> metrics_columns();
std::vector<std::string> metrics_cells(std::int64_t step, double time, const Observables& seen);
std::vector<std::string> pups_columns();
std::vector<std::vector<std::string>> pups_cells(const LitterView& litter);

/// Reads a CSV file of this program row by row. Throws Failure(bad_file).
class CsvReader {
 public:
  explicit CsvReader(const std::string& path);

  /// The comment lines before the column names, without "# ".
  const std::vector<std::string>& comments() const { return comments_; }
  const std::vector<std::string>& columns() const { return columns_; }

  /// The comment lines among and behind the rows that were read, without "# ".
  const std::vector<std::string>& remarks() const { return remarks_; }

  /// The next row that is no comment; nothing at the end. Throws Failure(bad_input) when it has not
  /// as many cells as there are columns.
  std::optional<std::vector<std::string>> next();

  /// "FILE:line" of the last row, for messages.
  std::string where() const { return path_ + ":" + std::to_string(line_); }

 private:
  bool read_line(std::string& line);
  std::string path_;
  std::ifstream file_;
  std::vector<std::string> comments_, columns_, remarks_;
  std::int64_t line_ = 0;
};

/// The "# name = value" lines at the beginning of a CSV file. Throws Failure(bad_file) when it
/// cannot be read.
TextEntries read_csv_header(const std::string& path);

}  // namespace pupflow::io
