#include "app/study/results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"

namespace pupflow::study {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// The cells before the status: varied values, then the seed.
std::string key_text(const Design& design, std::int64_t run) {
  std::string text;
  const std::vector<double> values = design.values_at(run / design.seeds);
  for (std::size_t a = 0; a < values.size(); ++a) {
    text += format_value(*design.axes[a].parameter, values[a]) + ",";
  }
  return text + std::to_string(design.seed_of(run)) + ",";
}

std::string varied_names(const Design& design) {
  std::string names;
  for (const Axis& axis : design.axes) names += std::string(axis.parameter->name) + ",";
  return names;
}

Spread spread_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (values.empty()) return {kNothing, kNothing};
  double mean = 0, square = 0;
  for (const double value : values) mean += value / n;
  for (const double value : values) square += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? kNothing : std::sqrt(square / (n - 1))};
}

Summary summarise_point(const Design& design, const std::vector<const Row*>& rows) {
  Summary summary;
  summary.values = design.values_at(rows.front()->run / design.seeds);
  std::array<std::vector<double>, kRunStatisticCount> values;
  for (const Row* row : rows) {
    if (!row->fine()) {
      ++summary.failed;
      continue;
    }
    ++summary.runs;
    summary.warned += row->warned() ? 1 : 0;
    for (std::size_t k = 0; k < kRunStatisticCount; ++k) values[k].push_back(statistic(*row, k));
  }
  for (const auto& column : values) summary.statistics.push_back(spread_of(column));
  return summary;
}

/// |dA/dT_a| between two points.
double slope(const Summary& a, const Summary& b, std::size_t axis) {
  constexpr std::size_t kHuddling = statistic_of(Observable::huddling);
  const double fall = a.statistics[kHuddling].mean - b.statistics[kHuddling].mean;
  const double way = b.values[axis] - a.values[axis];
  return way == 0 ? kNothing : std::abs(fall / way);
}

/// The slope along ta: central differences inside, one-sided at the ends.
void add_susceptibility(const Design& design, std::vector<Summary>& summaries) {
  for (Summary& summary : summaries) summary.susceptibility = kNothing;
  const auto ta = std::find_if(design.axes.begin(), design.axes.end(),
                               [](const Axis& axis) { return axis.parameter->name == "ta"; });
  if (ta == design.axes.end()) return;
  const auto axis = static_cast<std::size_t>(ta - design.axes.begin());
  std::map<std::vector<double>, std::vector<Summary*>> curves;  // by the values of all other axes
  for (Summary& summary : summaries) {
    std::vector<double> others = summary.values;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(axis));
    curves[others].push_back(&summary);
  }
  for (auto& [others, curve] : curves) {
    std::stable_sort(curve.begin(), curve.end(), [&](const Summary* a, const Summary* b) {
      return a->values[axis] < b->values[axis];
    });
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Summary &before = *curve[i > 0 ? i - 1 : i],
                    &after = *curve[std::min(i + 1, curve.size() - 1)];
      curve[i]->susceptibility = slope(before, after, axis);
    }
  }
}

/// Comment lines that tell how the file was made: the manifest.
void write_header(io::AtomicFile& file, const Design& design) {
  io::TextStream lines(manifest_text(design));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) file.write("# " + line + "\n");
  }
}

}  // namespace

double& statistic(Row& row, std::size_t i) {
  return i == kExposedSd ? row.exposed_sd : row.means.*observables()[i].value;
}

double statistic(const Row& row, std::size_t i) {
  return i == kExposedSd ? row.exposed_sd : row.means.*observables()[i].value;
}

Row make_row(std::int64_t run, const RunResult& result) {
  Row row;
  row.run = run;
  row.means = result.means;
  row.exposed_sd = result.exposed_sd;
  row.status = result.status.message();
  std::replace(row.status.begin(), row.status.end(), ',', ';');
  const std::string warnings = warnings_text(result.warnings.all());
  if (!warnings.empty()) row.status += "; " + warnings;
  if (result.status.ok()) return row;
  for (std::size_t i = 0; i < kRunStatisticCount; ++i) statistic(row, i) = kNothing;
  return row;
}

std::string runs_columns(const Design& design) {
  std::string names = varied_names(design) + "seed,status";
  for (const Field& field : run_statistics()) names.append(",").append(field.name);
  return names;
}

std::string row_text(const Design& design, const Row& row) {
  std::string text = key_text(design, row.run) + row.status;
  for (std::size_t i = 0; i < kRunStatisticCount; ++i) {
    text += "," + io::number_text(statistic(row, i));
  }
  return text;
}

std::size_t largest_file(const Design& design) {
  constexpr std::size_t kHeader = std::size_t{1} << 27, kRow = 8192;
  return kHeader + static_cast<std::size_t>(design.own_count()) * kRow;
}

std::optional<Row> parse_row(const Design& design, std::int64_t run, const std::string& line) {
  const std::string key = key_text(design, run);
  if (!line.starts_with(key)) return std::nullopt;
  const auto cells = io::split(std::string_view(line).substr(key.size()), ',');
  if (cells.size() != 1 + kRunStatisticCount || cells[0].empty()) return std::nullopt;
  const auto plain = [](char c) { return c >= ' ' && c <= '~'; };  // it is printed on terminals
  if (!std::all_of(cells[0].begin(), cells[0].end(), plain)) return std::nullopt;
  Row row;
  row.run = run;
  row.status = cells[0];
  for (std::size_t i = 0; i < kRunStatisticCount; ++i) {
    const auto number = io::read_number<double>(cells[1 + i]);
    if (!number) return std::nullopt;
    statistic(row, i) = *number;
  }
  if (row_text(design, row) != line) return std::nullopt;
  return row;
}

std::vector<Summary> summarise(const Design& design, const std::vector<Row>& rows) {
  std::vector<std::vector<const Row*>> points;
  std::map<std::vector<double>, std::size_t> places;  // of rows with given seeds
  for (const Row& row : rows) {
    const std::int64_t point = row.run / design.seeds;
    auto place = static_cast<std::size_t>(point);
    if (!design.given_seeds.empty())
      place = places.try_emplace(design.values_at(point), places.size()).first->second;
    if (place >= points.size()) points.resize(place + 1);
    points[place].push_back(&row);
  }
  std::vector<Summary> summaries;
  summaries.reserve(points.size());
  for (const auto& point : points) summaries.push_back(summarise_point(design, point));
  add_susceptibility(design, summaries);
  return summaries;
}

std::string seeds_text(const std::vector<Summary>& summaries) {
  std::int64_t least = 0, most = 0;
  for (const Summary& summary : summaries) {
    const std::int64_t seeds = summary.runs + summary.failed;
    least = most == 0 ? seeds : std::min(least, seeds);
    most = std::max(most, seeds);
  }
  const std::string to = least < most ? " to " + std::to_string(most) : "";
  return std::to_string(least) + to + (most == 1 ? " seed" : " seeds");
}

std::string summary_columns(const Design& design) {
  std::string names = varied_names(design) + "runs";
  for (const Field& field : run_statistics()) {
    const std::string name(field.name);
    names += "," + name + "," + name + "_sd";
  }
  return names + ",susceptibility,failed,warned";
}

std::string summary_text(const Design& design, const Summary& summary) {
  std::string line;
  for (std::size_t a = 0; a < summary.values.size(); ++a)
    line += format_value(*design.axes[a].parameter, summary.values[a]) + ",";
  line += std::to_string(summary.runs);
  for (const Spread& spread : summary.statistics)
    line += "," + io::number_text(spread.mean) + "," + io::number_text(spread.sd);
  return line + "," + io::number_text(summary.susceptibility) + "," +
         std::to_string(summary.failed) + "," + std::to_string(summary.warned);
}

void write_runs(const std::string& path, const Design& design, const std::vector<Row>& rows) {
  io::AtomicFile file(path, true);
  write_header(file, design);
  file.write(runs_columns(design) + "\n");
  for (const Row& row : rows) file.write(row_text(design, row) + "\n");
  file.commit();
}

void write_summary(const std::string& path, const Design& design,
                   const std::vector<Summary>& summaries) {
  io::AtomicFile file(path, true);
  write_header(file, design);
  file.write(summary_columns(design) + "\n");
  for (const Summary& summary : summaries) file.write(summary_text(design, summary) + "\n");
  file.commit();
}

std::vector<Row> read_runs(const std::string& path, const Design& design) {
  io::TextStream lines(io::read_file(path, largest_file(design)));
  const std::int64_t total = design.own_count();
  std::vector<Row> rows;
  bool columns = false;
  std::int64_t number = 0;
  const auto refuse = [&](const std::string& what) {
    io::refuse(path + ":" + std::to_string(number) + ": " + what);
  };
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with('#')) continue;
    if (!columns) {
      columns = true;
      if (line == runs_columns(design)) continue;
      refuse("the columns are not those of its manifest");
    }
    const auto row = std::ssize(rows) < total
                         ? parse_row(design, design.own_run(std::ssize(rows)), line)
                         : std::nullopt;
    if (!row)
      refuse("this row is damaged or of another sweep; remove the file to compute its runs again");
    rows.push_back(*row);
  }
  if (std::ssize(rows) != total) {
    io::refuse(path + ": holds " + std::to_string(rows.size()) + " of " + std::to_string(total) +
               " runs; remove it to compute them again");
  }
  return rows;
}

}  // namespace pupflow::study
