#include "app/study/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/io/celsius.h"
#include "app/io/failure.h"
#include "app/io/json.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "app/study/files.h"
#include "pupflow/observer.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

using io::refuse;

/// A summary CSV: columns by name.
struct Table {
  std::string path;
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  bool has(std::string_view name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  std::size_t column(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      refuse(path + ": has no column " + name + "; is it a sweep's summary.csv?");
    return static_cast<std::size_t>(found - names.begin());
  }

  double number(std::size_t row, const std::string& name) const {
    const std::string& text = rows[row][column(name)];
    const auto value = io::read_number<double>(text);
    if (value) return *value;
    refuse(path + ": row " + std::to_string(row + 1) + ": " + name +
           " is no number: " + io::quoted(text));
  }
};

/// The summary that a path means.
std::string summary_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return path;
  if (fs::exists(summary_path(path), error)) return summary_path(path);
  if (fs::exists(manifest_path(path), error))
    refuse(path + ": has no summary.csv: the sweep is not finished, or one of several shards");
  refuse(path + ": is no folder of a sweep: it has no summary.csv");
}

Table read_table(const std::string& path) {
  Table table{path, {}, {}};
  io::TextStream lines(io::read_file(path, std::size_t{1} << 30));
  std::int64_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.starts_with('#')) continue;
    const auto parts = io::split(line, ',');
    std::vector<std::string> cells(parts.begin(), parts.end());
    if (table.names.empty()) {
      table.names = std::move(cells);
      continue;
    }
    if (cells.size() != table.names.size())
      refuse(path + ":" + std::to_string(number) + ": has " + std::to_string(cells.size()) +
             " cells, and the header " + std::to_string(table.names.size()));
    table.rows.push_back(std::move(cells));
  }
  table.column("runs");
  if (table.rows.empty()) refuse(path + ": has no rows to compare");
  return table;
}

bool same_value(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto x = io::read_number<double>(a), y = io::read_number<double>(b);
  return x && y && std::abs(*x - *y) <= 1e-5 * std::max({std::abs(*x), std::abs(*y), 1e-1});
}

bool holds(const Table& table, const std::string& observable) {
  return table.has(observable) && table.has(observable + "_sd");
}

/// Sorts the observables into those that both tables hold and those that are left out.
void choose_observables(const Table& a, const Table& b, Comparison& comparison) {
  for (const Field& field : observables()) {
    const std::string name(field.name);
    (holds(a, name) && holds(b, name) ? comparison.observables : comparison.left_out)
        .push_back(name);
  }
  if (comparison.observables.empty())
    refuse(b.path + ": has no observable with its _sd in common with " + a.path);
}

/// Difference of two means in units of its standard error; 0 where both are the same without
/// spread.
double in_standard_errors(const Table& a, const Table& b, std::size_t row,
                          const std::string& name) {
  const auto squared_error = [&](const Table& t) {
    const double sd = t.number(row, name + "_sd");
    return sd * sd / t.number(row, "runs");
  };
  const double difference = a.number(row, name) - b.number(row, name);
  return difference == 0 ? 0 : difference / std::sqrt(squared_error(a) + squared_error(b));
}

}  // namespace

Comparison compare_summaries(const std::string& first, const std::string& second) {
  const Table a = read_table(summary_of(first)), b = read_table(summary_of(second));
  Comparison comparison;
  comparison.varied.assign(a.names.begin(),
                           a.names.begin() + static_cast<std::ptrdiff_t>(a.column("runs")));
  if (!std::equal(b.names.begin(), b.names.begin() + static_cast<std::ptrdiff_t>(b.column("runs")),
                  comparison.varied.begin(), comparison.varied.end())) {
    refuse(second + ": does not vary the same parameters as " + first);
  }
  if (a.rows.size() != b.rows.size()) {
    refuse(second + ": has " + std::to_string(b.rows.size()) + " rows, " + first + " has " +
           std::to_string(a.rows.size()));
  }
  choose_observables(a, b, comparison);
  double squares = 0;
  for (std::size_t row = 0; row < a.rows.size(); ++row) {
    comparison.key.emplace_back();
    for (const std::string& name : comparison.varied) {
      const std::string& value = a.rows[row][a.column(name)];
      if (!same_value(value, b.rows[row][b.column(name)])) {
        refuse(second + ": row " + std::to_string(row + 1) + " has " + name + " = " +
               b.rows[row][b.column(name)] + ", not " + value);
      }
      comparison.key.back().push_back(value);
    }
    for (const std::string& name : comparison.observables) {
      const double z = in_standard_errors(a, b, row, name);
      comparison.differences.push_back({row, name, a.number(row, name), b.number(row, name), z});
      comparison.beyond_three += std::abs(z) > 3 ? 1 : 0;
      comparison.unknown += std::isnan(z) ? 1 : 0;
      squares += std::isnan(z) ? 0 : z * z;
      if (name != observables()[statistic_of(Observable::mean_tb)].name) continue;
      comparison.largest_tb =
          std::max(comparison.largest_tb, std::abs(a.number(row, name) - b.number(row, name)));
      if (!std::isnan(z)) {
        comparison.largest_tb_errors = std::max(comparison.largest_tb_errors, std::abs(z));
      }
    }
  }
  const std::size_t count =
      comparison.differences.size() - static_cast<std::size_t>(comparison.unknown);
  comparison.rms = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
  return comparison;
}

std::string comparison_text(const Comparison& comparison, bool celsius) {
  std::string text = "difference of the means in combined standard errors\n";
  constexpr int kWidth = 9;
  char cell[96];
  for (const std::string& name : comparison.varied) {
    std::snprintf(cell, sizeof cell, "%12s", io::printable(name).c_str());
    text += cell;
  }
  for (const std::string& name : comparison.observables) {
    std::snprintf(cell, sizeof cell, " %*s", kWidth, name.c_str());
    text += cell;
  }
  for (std::size_t i = 0; i < comparison.differences.size(); ++i) {
    const Difference& d = comparison.differences[i];
    if (i % comparison.observables.size() == 0) {
      text += "\n";
      for (const std::string& value : comparison.key[d.row]) {
        std::snprintf(cell, sizeof cell, "%12.10s", io::printable(value).c_str());
        text += cell;
      }
    }
    const int width = std::max(kWidth, static_cast<int>(d.observable.size()));
    std::snprintf(cell, sizeof cell, " %+*.1f", width, d.standard_errors);
    text += cell;
  }
  std::snprintf(cell, sizeof cell, "\n%d of %zu points beyond 3", comparison.beyond_three,
                comparison.differences.size() - static_cast<std::size_t>(comparison.unknown));
  text += cell;
  if (comparison.unknown > 0) {
    std::snprintf(cell, sizeof cell, ", %d unknown: fewer than two runs", comparison.unknown);
    text += cell;
  }
  text += io::formatted(", rms %.2f, mean_tb within %.4f", comparison.rms, comparison.largest_tb);
  if (celsius) text += io::formatted(" (%.2f \u00b0C)", io::celsius(comparison.largest_tb));
  text += io::formatted(" and %.1f standard errors\n", comparison.largest_tb_errors);
  for (const std::string& name : comparison.left_out)
    text += name + " was not compared: it is not in both files\n";
  return text;
}

std::string comparison_json(const Comparison& comparison) {
  std::vector<std::string> points, left_out;
  for (const Difference& difference : comparison.differences) {
    io::JsonObject point;
    for (std::size_t i = 0; i < comparison.varied.size(); ++i) {
      point.emplace_back(comparison.varied[i], io::json_string(comparison.key[difference.row][i]));
    }
    point.emplace_back("observable", io::json_string(difference.observable));
    point.emplace_back("first", io::json_number(difference.first));
    point.emplace_back("second", io::json_number(difference.second));
    point.emplace_back("standard_errors", io::json_number(difference.standard_errors));
    points.push_back(io::json_object(point));
  }
  for (const std::string& name : comparison.left_out) left_out.push_back(io::json_string(name));
  return io::json_file({{"points", io::json_array(points)},
                        {"beyond_three", std::to_string(comparison.beyond_three)},
                        {"unknown", std::to_string(comparison.unknown)},
                        {"rms", io::json_number(comparison.rms)},
                        {"largest_tb", io::json_number(comparison.largest_tb)},
                        {"largest_tb_errors", io::json_number(comparison.largest_tb_errors)},
                        {"left_out", io::json_array(left_out)}});
}

}  // namespace pupflow::study
