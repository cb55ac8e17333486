#include "app/io/about.h"

#include <algorithm>
#include <fstream>

#include "app/io/file_kind.h"
#include "app/io/hdf5_reader.h"
#include "app/io/params_of_file.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "pupflow/fields.h"

namespace pupflow::io {
namespace {

/// What entries tell: parameters, software, and the rest as facts.
About about_entries(const TextEntries& entries, const std::string& path) {
  About about;
  about.params = params_from(entries, path);
  for (const auto& [name, value] : entries) {
    if (name == "Software" || name == "software") {
      about.software = value;
    } else if (name == "kind") {
      about.kind = value;
    } else if (!find_parameter(name)) {
      about.facts.emplace_back(name, value);
    }
  }
  return about;
}

std::string range_text(double first, double last) {
  return number_text(first) + " to " + number_text(last);
}

About about_hdf5(const std::string& path) {
  const Hdf5Reader file(path);
  About about = about_entries(file.text(), path);
  about.sets = file.sets();
  if (file.unfinished()) about.facts.emplace_back("unfinished", "its run goes on, or was killed");
  const bool told_step = std::any_of(about.facts.begin(), about.facts.end(),
                                     [](const auto& fact) { return fact.first == "step"; });
  for (const SetInfo& set : about.sets) {
    if (set.name == "clock" && set.shape == std::vector<std::uint64_t>{3} && !told_step) {
      about.facts.emplace_back("step", number_text(file.numbers("clock", {3})[0]));
    }
    if (set.name != "step" || set.shape.size() != 1) continue;
    const std::uint64_t frames = set.shape[0];
    about.facts.emplace_back("frames", std::to_string(frames));
    if (frames == 0 || !file.has("time")) continue;
    for (const char* name : {"step", "time"}) {
      double first = 0, last = 0;
      file.part(name, {0}, {1}, NumberType::f8, &first);
      file.part(name, {frames - 1}, {1}, NumberType::f8, &last);
      about.facts.emplace_back(name + std::string("s of frames"), range_text(first, last));
    }
  }
  return about;
}

About about_png(const std::string& path) {
  About about = about_entries(read_png_text(path), path);
  about.kind = "picture";
  const std::string beginning = read_beginning(path, 24);
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(beginning.at(i));
    }
    return std::to_string(value);
  };
  about.facts.emplace_back("size", number(16) + " x " + number(20) + " pixels");
  return about;
}

/// The kind of a CSV file by its columns.
std::string csv_kind(const std::string& columns) {
  if (columns.starts_with("step,time,")) return "metrics CSV";
  if (columns.starts_with("step,pup,")) return "pups CSV";
  if (columns.find("seed,status,") != std::string::npos) return "runs CSV of a sweep";
  if (columns.find("runs,") != std::string::npos) return "summary CSV of a sweep";
  return "CSV";
}

/// The row of any table of outputs for a column.
const Field* field_of(std::string_view column, bool of_pups) {
  if (of_pups) return find_field(column);
  for (const ObservableField& row : observables()) {
    if (row.name == column) return &row;
  }
  return nullptr;
}

/// A comment behind the rows: "# name = value" or "# name: text".
void take_remark(const std::string& line, TextEntries& facts) {
  const std::size_t equals = line.find(" = "), colon = line.find(": ");
  const std::size_t at = std::min(equals, colon);
  if (at == std::string::npos) return;
  facts.emplace_back(line.substr(2, at - 2), line.substr(at + (at == equals ? 3 : 2)));
}

About about_csv(const std::string& path) {
  About about = about_entries(entries_of_text(path), path);
  std::ifstream file(path);
  std::string line, columns;
  std::uint64_t rows = 0;
  while (std::getline(file, line)) {
    if (line.starts_with("# ") && !columns.empty()) take_remark(line, about.facts);
    if (line.starts_with('#') || line.empty()) continue;
    columns.empty() ? static_cast<void>(columns = line) : static_cast<void>(++rows);
  }
  about.kind = csv_kind(columns);
  about.facts.emplace_back("rows", std::to_string(rows));
  for (const std::string_view column : split(columns, ',')) {
    SetInfo set{std::string(column), {rows}, "text", {}, {}};
    if (const Field* field = field_of(column, about.kind == "pups CSV")) {
      set.units = field->unit;
      set.description = field->doc;
    }
    about.sets.push_back(std::move(set));
  }
  return about;
}

About about_any(const std::string& path) {
  switch (file_kind(path)) {
    case FileKind::picture:
      return about_png(path);
    case FileKind::hdf5:
      return about_hdf5(path);
    case FileKind::text:
      break;
  }
  return about_csv(path);
}

}  // namespace

About about_file(const std::string& path) {
  About about = about_any(path);
  for (std::string* text : {&about.kind, &about.software}) *text = printable(*text);
  for (auto& [name, value] : about.facts) {
    name = printable(name);
    value = printable(value);
  }
  for (SetInfo& set : about.sets) {
    for (std::string* text : {&set.name, &set.units, &set.description}) *text = printable(*text);
  }
  return about;
}

}  // namespace pupflow::io
