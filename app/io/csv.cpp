#include "app/io/csv.h"

#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

std::string metrics_columns() {
  std::string columns = "step,time";
  for (const Field& field : observables()) columns.append(",").append(field.name);
  return columns;
}

std::string pups_columns() {
  std::string columns = "step,pup,x,y,z";
  for (const LitterField& field : pup_fields()) {
    if (field.in_files) columns.append(",").append(field.name);
  }
  return columns;
}

}  // namespace

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

void CsvFile::comment(std::string_view text) {
  file_.write("# " + std::string(text) + "\n");
}

MetricsCsv::MetricsCsv(const std::string& path, bool force, const Params& params)
    : file_(path, force, provenance(params), metrics_columns()) {}

void MetricsCsv::add(const LitterView& litter, const Observables& seen) {
  file_.cell(litter.step).cell(litter.time);
  for (const ObservableField& row : observables()) file_.cell(seen.*row.value);
  file_.end_row();
}

PupsCsv::PupsCsv(const std::string& path, bool force, const Params& params)
    : file_(path, force, provenance(params), pups_columns()) {}

void PupsCsv::add(const LitterView& litter) {
  std::vector<std::vector<double>> columns;
  for (const LitterField& field : pup_fields()) {
    if (field.in_files) columns.push_back(field.values(litter));
  }
  for (int pup = 0; pup < litter.pups; ++pup) {
    const Eigen::Vector3d centre = litter.positions.mean(pup);
    file_.cell(litter.step).cell(std::int64_t{pup});
    file_.cell(centre.x()).cell(centre.y()).cell(centre.z());
    for (const std::vector<double>& column : columns) {
      file_.cell(column[static_cast<std::size_t>(pup)]);
    }
    file_.end_row();
  }
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
