#include "app/io/csv.h"

#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

std::string joined_cells(const std::vector<std::string>& cells) {
  return joined(cells, ",");
}

/// A comment line without "# ".
std::string comment(const std::string& line) {
  return line.substr(line.starts_with("# ") ? 2 : 1);
}

}  // namespace

std::vector<std::string> metrics_columns() {
  std::vector<std::string> columns{"step", "time"};
  for (const Field& field : observables()) columns.emplace_back(field.name);
  return columns;
}

std::vector<std::string> metrics_cells(std::int64_t step, double time, const Observables& seen) {
  std::vector<std::string> cells{std::to_string(step), number_text(time)};
  for (const ObservableField& row : observables()) cells.push_back(number_text(seen.*row.value));
  return cells;
}

std::vector<std::string> pups_columns() {
  std::vector<std::string> columns{"step", "pup", "x", "y", "z"};
  for (const LitterField& field : pup_fields()) {
    if (field.in_files) columns.emplace_back(field.name);
  }
  return columns;
}

std::vector<std::vector<std::string>> pups_cells(const LitterView& litter) {
  std::vector<std::vector<std::string>> rows;
  for (int pup = 0; pup < litter.pups; ++pup) {
    const Eigen::Vector3d centre = litter.positions.mean(pup);
    rows.push_back({std::to_string(litter.step), std::to_string(pup), number_text(centre.x()),
                    number_text(centre.y()), number_text(centre.z())});
  }
  for (const LitterField& field : pup_fields()) {
    if (!field.in_files) continue;
    const std::vector<double> values = field.values(litter);
    for (std::size_t pup = 0; pup < rows.size(); ++pup) {
      rows[pup].push_back(number_text(values[pup]));
    }
  }
  return rows;
}

CsvFile::CsvFile(const std::string& path, bool force, const TextEntries& header,
                 std::string_view columns)
    : file_(path, force) {
  for (const auto& [name, value] : header) {
    std::string line = name;
    comment(line.append(" = ").append(value));
  }
  file_.write(columns);
  file_.write("\n");
}

void CsvFile::add(std::string_view text) {
  if (!row_.empty()) row_ += ',';
  row_ += text;
}

CsvFile& CsvFile::cell(double value) {
  add(number_text(value));
  return *this;
}

CsvFile& CsvFile::cell(std::int64_t value) {
  add(std::to_string(value));
  return *this;
}

CsvFile& CsvFile::cell(std::string_view words) {
  add(words);
  return *this;
}

void CsvFile::end_row() {
  row_ += '\n';
  file_.write(row_);
  row_.clear();
}

void CsvFile::row(const std::vector<std::string>& cells) {
  row_ = joined_cells(cells);
  end_row();
}

void CsvFile::comment(std::string_view text) {
  file_.write("# " + std::string(text) + "\n");
}

MetricsCsv::MetricsCsv(const std::string& path, bool force, const Simulation& start)
    : file_(path, force, provenance(start), joined_cells(metrics_columns())) {}

void MetricsCsv::add(const LitterView& litter, const Observables& seen) {
  file_.row(metrics_cells(litter.step, litter.time, seen));
}

PupsCsv::PupsCsv(const std::string& path, bool force, const Simulation& start)
    : file_(path, force, provenance(start), joined_cells(pups_columns())) {}

void PupsCsv::add(const LitterView& litter) {
  for (const std::vector<std::string>& cells : pups_cells(litter)) file_.row(cells);
}

CsvReader::CsvReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  read_beginning(path, 1);  // says what is wrong with a file that cannot be read at all
  std::string line;
  while (read_line(line) && line.starts_with('#')) comments_.push_back(comment(line));
  for (const std::string_view column : split(line, ',')) columns_.emplace_back(column);
}

bool CsvReader::read_line(std::string& line) {
  constexpr std::size_t kLongest = 1 << 16;
  ++line_;
  line.clear();
  for (int letter = 0; (letter = file_.get()) != EOF;) {
    if (letter == '\n') return true;
    line += static_cast<char>(letter);
    if (line.size() > kLongest) refuse(where() + ": is too long for a line of a CSV file");
  }
  if (file_.bad()) throw Failure(ExitCode::bad_file, path_ + ": cannot be read further");
  return !line.empty();
}

std::optional<std::vector<std::string>> CsvReader::next() {
  std::string line;
  while (read_line(line)) {
    if (line.starts_with('#')) {
      remarks_.push_back(comment(line));
      continue;
    }
    std::vector<std::string> cells;
    for (const std::string_view cell : split(line, ',')) cells.emplace_back(cell);
    if (cells.size() != columns_.size()) {
      refuse(where() + ": has " + std::to_string(cells.size()) + " cells, not " +
             std::to_string(columns_.size()));
    }
    return cells;
  }
  return std::nullopt;
}

TextEntries read_csv_header(const std::string& path) {
  constexpr std::size_t kLongestHeader = 1 << 16;
  const std::string bytes = read_beginning(path, kLongestHeader);
  TextEntries entries;
  std::string_view rest = bytes;
  while (rest.starts_with('#')) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(1, end == std::string_view::npos ? end : end - 1);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with(' ')) line.remove_prefix(1);
    const std::size_t equals = line.find(" = ");
    if (equals == std::string_view::npos) continue;
    std::string_view value = line.substr(equals + 3);
    // A sweep's header is TOML, which quotes words.
    if (value.size() >= 2 && value.starts_with('"') && value.ends_with('"')) {
      value = value.substr(1, value.size() - 2);
    }
    entries.emplace_back(line.substr(0, equals), value);
  }
  return entries;
}

}  // namespace pupflow::io
