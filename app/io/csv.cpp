#include "app/io/csv.h"

#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

std::string observable_columns() {
  std::string columns;
  for (const ObservableName& row : observable_names()) columns.append(",").append(row.name);
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
    : file_(path, force, provenance(params), "step,time" + observable_columns()) {}

void MetricsCsv::add(const Simulation& simulation, const Observables& observables) {
  file_.cell(simulation.steps_done()).cell(simulation.time());
  for (const ObservableName& row : observable_names()) file_.cell(observables.*row.value);
  file_.end_row();
}

PupsCsv::PupsCsv(const std::string& path, bool force, const Params& params)
    : file_(path, force, provenance(params), "step,pup,x,y,z,tb,exposed,heading") {}

void PupsCsv::add(const Simulation& simulation) {
  for (int pup = 0; pup < simulation.pups(); ++pup) {
    const Eigen::Vector3d centre = simulation.centre(pup);
    const auto j = static_cast<std::size_t>(pup);
    file_.cell(simulation.steps_done()).cell(std::int64_t{pup});
    file_.cell(centre.x()).cell(centre.y()).cell(centre.z());
    file_.cell(simulation.body_temperature()[j]);
    file_.cell(simulation.exposed()[j]).cell(simulation.heading()[j]);
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
