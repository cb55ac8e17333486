// The page of a comparison seed by seed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/report/error/paired.h"

namespace pupflow::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string without_commas(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  return text;
}

/// A row of the intervals for another number of seeds.
struct SeedRow {
  std::int64_t seeds;
  double seconds;
  std::vector<double> intervals;  // by observable
};

std::vector<SeedRow> seed_rows(const Paired& paired, std::initializer_list<double> factors) {
  std::vector<SeedRow> rows;
  for (const double factor : factors) {
    const auto seeds = static_cast<std::int64_t>(factor * static_cast<double>(paired.seeds));
    if (seeds < 2) continue;
    const double share = static_cast<double>(seeds) / static_cast<double>(paired.seeds);
    rows.push_back({seeds, share * paired.rows[0].seconds, {}});
    for (std::size_t i = 0; i < paired.observables.size(); ++i) {
      rows.back().intervals.push_back(interval_with(paired, i, seeds));
    }
  }
  return rows;
}

void write_csv(const Report& report, const std::string& name, const Paired& paired) {
  std::string columns = "group,setting,seeds,bad,status,cpu_seconds,cpu_ratio";
  for (const std::string& o : paired.observables) {
    columns += "," + o + "," + o + "_interval," + o + "_difference," + o + "_difference_interval";
  }
  const Compared& base = paired.rows.front();
  io::CsvFile csv = report.csv(name, base.change.params, columns);
  for (const Compared& row : paired.rows) {
    const std::string trouble = row.trouble(paired.seeds);
    csv.cell(std::string_view(row.change.group.empty() ? "base" : row.change.group));
    csv.cell(std::string_view(without_commas(row.change.label)));
    csv.cell(row.refused.empty() ? paired.seeds : 0).cell(row.bad);
    csv.cell(std::string_view(trouble.empty() ? "fine" : without_commas(trouble)));
    csv.cell(row.seconds).cell(row.seconds / base.seconds);
    for (std::size_t i = 0; i < paired.observables.size(); ++i) {
      csv.cell(row.means[i].mean).cell(row.means[i].interval);
      csv.cell(row.differences[i].mean).cell(row.differences[i].interval);
    }
    csv.end_row();
  }
  for (const SeedRow& row : seed_rows(paired, {0.25, 0.5, 1, 2, 4})) {
    csv.cell(std::string_view("seeds")).cell(std::to_string(row.seeds) + " seeds");
    csv.cell(row.seeds).cell(std::int64_t{0}).cell(std::string_view("expected"));
    csv.cell(row.seconds).cell(row.seconds / base.seconds);
    for (const double interval : row.intervals)
      csv.cell(kNone).cell(interval).cell(kNone).cell(kNone);
    csv.end_row();
  }
  csv.commit();
}

void add_table(Report& report, const Paired& paired) {
  std::vector<io::Row> rows{{"varied", "setting", "CPU s (× base)"}};
  for (const std::string& o : paired.observables) {
    rows[0].push_back(o);
    rows[0].push_back("change of " + o);
  }
  const double base_seconds = paired.rows.front().seconds;
  const auto seconds_words = [&](double seconds) {
    return rounded(seconds) + " (" + rounded(seconds / base_seconds, 2) + ")";
  };
  const auto time_words = [&](const Compared& row) -> std::string {
    if (!row.refused.empty()) return check(row.change.params).empty() ? "no means" : "refused";
    const std::string bad = row.bad == 0 ? "" : ", " + std::to_string(row.bad) + " bad";
    const std::string warned = row.warned == 0 ? "" : ", " + std::to_string(row.warned) + " warned";
    return seconds_words(row.seconds) + bad + warned;
  };
  for (const Compared& row : paired.rows) {
    const bool is_base = row.change.group.empty();
    io::Row cells{is_base ? "**base**" : row.change.group, row.change.label, time_words(row)};
    for (std::size_t i = 0; i < paired.observables.size(); ++i) {
      const Estimate& change = row.differences[i];
      const std::string words = words_of(change, true);
      cells.push_back(words_of(row.means[i]));
      cells.push_back(is_base ? "" : change.beyond_chance() ? "**" + words + "**" : words);
    }
    rows.push_back(std::move(cells));
  }
  for (const SeedRow& row : seed_rows(paired, {0.5, 2})) {
    io::Row cells{"seeds", std::to_string(row.seeds) + " (expected)", seconds_words(row.seconds)};
    for (const double interval : row.intervals) {
      cells.push_back("± " + rounded(interval, 2));
      cells.emplace_back("");
    }
    rows.push_back(std::move(cells));
  }
  report.table(rows);
  for (const Compared& row : paired.rows) {
    const std::string trouble = row.trouble(paired.seeds);
    if (trouble.empty()) continue;
    const std::string what =
        row.change.group.empty() ? "The base" : row.change.group + ", " + row.change.label;
    report.text("*" + what + "*: " + trouble + ".");
  }
}

/// Whether a panel with logarithmic axes would show a point.
bool drawable(const Paired& paired, std::size_t observable) {
  return std::any_of(paired.rows.begin(), paired.rows.end(), [&](const Compared& row) {
    const Estimate& change = row.differences[observable];
    return !row.change.group.empty() && std::abs(change.mean) + change.interval > 0;
  });
}

std::string panel(const std::string& file, const std::string& observable,
                  const std::vector<std::string>& groups) {
  const char* const colors[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                "#E69F00", "#56B4E9", "#7f5539"};
  const std::string time = " ? column('cpu_seconds') : NaN)";
  std::string text = "  plot '" + file + "' using (strcol('group') eq 'seeds'" + time +
                     ":(column('" + observable +
                     "_interval')) with lines lw 1.6 lc '#444444' title 'interval of the mean, "
                     "fewer to more seeds'";
  const std::string size = "abs(column('" + observable + "_difference'))";
  const std::string interval = "column('" + observable + "_difference_interval')";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string own =
        "'" + file + "' using (strcol('group') eq '" + groups[g] + "' && " + size;
    const std::string style = " ps 0.8 lc '" + std::string(colors[g % std::size(colors)]) + "' ";
    text += ", \\\n       " + own + " > " + interval + time + ":(" + size + "):(" + size + " - " +
            interval + "):(" + size + " + " + interval + ") with yerrorbars pt 7" + style +
            "title '" + groups[g] + "'";
    text += ", \\\n       " + own + " <= " + interval + time + ":(" + size + " + " + interval +
            ") with points pt 11" + style + "notitle";
  }
  return text + ", \\\n       NaN with points pt 11 lc '#444444' title 'upper bound'\n";
}

void add_plot(Report& report, const std::string& name, const std::string& caption,
              const Paired& paired) {
  std::vector<std::string> drawn, groups;
  for (std::size_t i = 0; i < paired.observables.size(); ++i) {
    if (drawable(paired, i)) drawn.push_back(paired.observables[i]);
  }
  if (drawn.empty()) return;
  for (const Compared& row : paired.rows) {
    const std::string& group = row.change.group;
    if (group.empty() || !std::isfinite(row.differences[0].interval)) continue;
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  const int width = std::max(760, 380 * static_cast<int>(drawn.size()) + 60);
  std::string body =
      "  set logscale xy\n  set xlabel 'CPU seconds'\n  set format y '%g'\n  set grid lt 1 lc rgb "
      "'#dddddd'\n  set "
      "multiplot layout 1," +
      std::to_string(drawn.size()) + " margins " + rounded(95.0 / width) +
      ",0.965,0.38,0.93 spacing " + rounded(75.0 / width) + ",0\n";
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    body += "  set title '" + drawn[i] + "' noenhanced\n";
    body += i == 0
                ? "  set ylabel 'size of the change'\n  set key at screen 0.02, screen 0.02 left "
                  "bottom maxrows 5 Left reverse\n"
                : "  unset ylabel\n  unset key\n";
    body += panel(name + ".csv", drawn[i], groups);
  }
  body += "  unset multiplot\n";
  report.figure(name, caption, body, paired.rows.front().change.params, width, 520);
}

}  // namespace

double interval_with(const Paired& paired, std::size_t observable, std::int64_t seeds) {
  const auto per_error = [](std::int64_t n) {
    return interval_factor(n) / std::sqrt(static_cast<double>(n));
  };
  const std::int64_t good = paired.seeds - paired.rows.front().bad;
  return paired.rows.front().means[observable].interval * per_error(seeds) / per_error(good);
}

std::string words_of(const Estimate& estimate, bool sign) {
  const double interval = estimate.interval;
  const std::string plus = sign && estimate.mean > 0 ? "+" : "";
  if (!std::isfinite(estimate.mean)) return "-";
  if (!std::isfinite(interval)) return plus + rounded(estimate.mean) + " ± -";
  if (!(interval >= 1e-6 && interval < 1e6)) {
    return plus + rounded(estimate.mean, 6) + " ± " + rounded(interval, 2);
  }
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(interval))));
  char text[80];
  std::snprintf(text, sizeof text, "%.*f ± %.*f", decimals, estimate.mean, decimals, interval);
  return plus + text;
}

std::string how_to_read() {
  return "A change is the mean difference from the base, seed by seed; ± is half of its 95 % "
         "interval (Student's t), and bold print means that the interval does not contain 0. By "
         "chance this happens to one change in twenty. CPU seconds are those of all runs of a row; "
         "rows that differ only in steps and discard share their runs. Rows with another step "
         "cover the same model seconds. Flow is over `flow_lag` steps in every row, so with "
         "another step it is over another time. In the plots a triangle is an upper bound: the "
         "interval contains 0.";
}

void show(Report& report, const std::string& name, const std::string& caption,
          const Paired& paired) {
  write_csv(report, name, paired);
  add_plot(report, name, caption, paired);
  add_table(report, paired);
}

}  // namespace pupflow::report
