#include "app/report/error_litter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "engine/ensemble.h"

namespace pupflow::report {
namespace {

constexpr std::size_t kMeans = 4;
constexpr std::array<const char*, kMeans> kNames{"mean_tb", "huddling", "groups", "flow"};
constexpr std::array<const char*, kMeans> kTitles{"T_b", "huddling 1 - A", "groups", "pup flow"};

using Means = std::array<double, kMeans>;

/// Several runs of one setting that differ in their seeds.
struct Sample {
  std::string group, label;
  Params params;
  std::int64_t runs = 0;
  double cpu_seconds = 0;
  Means mean{}, sd{};

  double half_width(std::size_t i) const {
    return interval_factor(runs) * sd[i] / std::sqrt(static_cast<double>(runs));
  }
};

/// Processor time of all threads of this process.
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Sample summary(Sample sample, const std::vector<Means>& runs) {
  sample.runs = static_cast<std::int64_t>(runs.size());
  const auto n = static_cast<double>(runs.size());
  for (std::size_t i = 0; i < kMeans; ++i) {
    for (const Means& run : runs) sample.mean[i] += run[i] / n;
    for (const Means& run : runs) sample.sd[i] += std::pow(run[i] - sample.mean[i], 2) / (n - 1);
    sample.sd[i] = std::sqrt(sample.sd[i]);
  }
  return sample;
}

/// Runs `count` litters of one setting with seeds from `first_seed` on; their means, by seed.
std::vector<Means> run_litters(const Params& params, std::int64_t first_seed, std::int64_t count,
                               int threads) {
  std::vector<Means> means(static_cast<std::size_t>(count));
  run_ensemble(
      count, threads,
      [&](std::int64_t run) {
        Params own = params;
        own.seed = first_seed + run;
        return own;
      },
      [&](std::int64_t run, const RunResult& result) {
        if (!result.status.ok()) {
          throw io::Failure(io::ExitCode::bad_numbers, "litter: " + result.status.message());
        }
        const Observables& o = result.means;
        means[static_cast<std::size_t>(run)] = {o.mean_tb, o.huddling, o.groups, o.flow};
      },
      io::interrupted);
  stop_if_interrupted();
  return means;
}

Sample sample_of(const Options& options, const std::string& group, const std::string& label,
                 const Params& params, std::int64_t first_seed, std::int64_t count) {
  const double begin = processor_seconds();
  const std::vector<Means> runs = run_litters(params, first_seed, count, options.threads);
  Sample sample = summary({group, label, params, 0, 0, {}, {}}, runs);
  sample.cpu_seconds = processor_seconds() - begin;
  return sample;
}

Params cold_litter(bool quick) {
  Params p;
  p.ta = 0.2;
  if (quick) p.steps = 400, p.discard = 200;
  return p;
}

/// What is varied, each with as many seeds.
std::vector<std::pair<std::string, std::pair<std::string, Params>>> variations(bool quick) {
  const Params base = cold_litter(quick);
  std::vector<std::pair<std::string, std::pair<std::string, Params>>> list;
  const auto add = [&](const std::string& group, const std::string& label, auto edit) {
    Params p = base;
    edit(p);
    list.push_back({group, {label, p}});
  };
  add("precision", "float", [](Params& p) { p.precision = Precision::float_; });
  add("heat", "Euler", [](Params& p) { p.heat = HeatRule::euler; });
  for (const int k : {4, 5, 6, 9}) {
    add("points", "k = " + std::to_string(k), [k](Params& p) { p.face_points = k; });
  }
  for (const int times : {2, 4}) {
    add("steps", std::to_string(times * base.steps) + " steps",
        [times](Params& p) { p.steps *= times; });
  }
  // The same model seconds at another step.
  const auto with_step = [](Params& p, double factor) {
    p.dt *= factor;
    p.steps = std::llround(static_cast<double>(p.steps) / factor);
    p.discard = std::llround(static_cast<double>(p.discard) / factor);
  };
  add("step (naive)", "dt = 0.02", [&](Params& p) { with_step(p, 2); });
  add("step (naive)", "dt = 0.005", [&](Params& p) { with_step(p, 0.5); });
  for (const int parts : {2, 4}) {
    add("step (consistent)", "dt = 0.01/" + std::to_string(parts), [&](Params& p) {
      with_step(p, 1.0 / parts);
      p.refinement = Refinement::consistent;
    });
  }
  return list;
}

void write_csv(const Report& report, const Sample& reference, const std::vector<Sample>& samples) {
  std::string columns = "group,setting,runs,cpu_seconds";
  for (const char* name : kNames) {
    columns += "," + std::string(name) + "," + name + "_sd," + name + "_interval," + name +
               "_difference," + name + "_difference_interval";
  }
  io::CsvFile csv = report.csv("litter", reference.params, columns);
  const auto row = [&](const Sample& sample) {
    csv.cell(std::string_view(sample.group)).cell(std::string_view(sample.label));
    csv.cell(sample.runs).cell(sample.cpu_seconds);
    for (std::size_t i = 0; i < kMeans; ++i) {
      csv.cell(sample.mean[i]).cell(sample.sd[i]).cell(sample.half_width(i));
      csv.cell(sample.mean[i] - reference.mean[i]);
      csv.cell(std::hypot(sample.half_width(i), reference.half_width(i)));
    }
    csv.end_row();
  };
  row(reference);
  for (const Sample& sample : samples) row(sample);
  csv.commit();
}

void add_table(Report& report, const Sample& reference, const std::vector<Sample>& samples) {
  std::vector<io::Row> rows{{"varied", "setting", "litters", "CPU s"}};
  for (const char* title : kTitles) rows[0].emplace_back(title);
  const auto cell = [](double mean, double interval, bool beyond) {
    const std::string text = rounded(mean, 3) + " ± " + rounded(interval, 2);
    return beyond ? "**" + text + "**" : text;
  };
  const auto row = [&](const Sample& sample, bool is_reference) {
    io::Row cells{is_reference ? "" : sample.group, sample.label, std::to_string(sample.runs),
                  rounded(sample.cpu_seconds)};
    for (std::size_t i = 0; i < kMeans; ++i) {
      const double difference = sample.mean[i] - reference.mean[i];
      const double interval = std::hypot(sample.half_width(i), reference.half_width(i));
      cells.push_back(is_reference ? cell(sample.mean[i], sample.half_width(i), false)
                                   : cell(difference, interval, std::abs(difference) > interval));
    }
    rows.push_back(cells);
  };
  row(reference, true);
  for (const Sample& sample : samples) row(sample, false);
  report.table(rows);
}

/// Which settings make another litter, as far as these runs can tell.
std::string verdict(const Sample& reference, const std::vector<Sample>& samples) {
  std::string other, same;
  for (const Sample& sample : samples) {
    if (sample.group == "seeds") continue;
    double furthest = 0;
    for (std::size_t i = 0; i < kMeans; ++i) {
      const double interval = std::hypot(sample.half_width(i), reference.half_width(i));
      furthest = std::max(furthest, std::abs(sample.mean[i] - reference.mean[i]) / interval);
    }
    std::string& list = furthest > 2 ? other : same;
    list += (list.empty() ? "" : "; ") + sample.group + ": " + sample.label;
  }
  return "**What this means.** Some mean is off by more than twice its interval with: " +
         (other.empty() ? "none" : other) +
         ". No such difference with: " + (same.empty() ? "none" : same) +
         ". Settings of the first kind are another model; settings of the second are a choice "
         "between time and nothing that these litters could show. The number of litters is the "
         "choice that buys exactness: four times as many halve the interval.";
}

void add_plot(Report& report, const Params& params) {
  std::string body =
      "  set logscale xy\n  set xlabel 'CPU seconds'\n  set grid lc '#dddddd'\n  set multiplot "
      "layout 1,4 margins 0.05,0.985,0.3,0.92 spacing 0.055,0\n";
  const char* const groups[] = {"seeds",     "points", "steps", "step (naive)", "step (consistent)",
                                "precision", "heat"};
  const char* const colors[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                "#E69F00", "#56B4E9", "#444444"};
  for (std::size_t i = 0; i < kMeans; ++i) {
    body += "  set title '" + std::string(kTitles[i]) + "'\n";
    body += i == 0 ? "  set ylabel 'size of the error, 95 % interval'\n  set key at screen 0.02, "
                     "screen 0.02 left bottom maxrows 2 Left reverse\n"
                   : "  unset ylabel\n  unset key\n";
    body += "  plot ";
    for (std::size_t g = 0; g < std::size(groups); ++g) {
      // Of the seeds the interval is the error; of all else the difference, with its interval.
      const std::string name = kNames[i], group = groups[g];
      const std::string pick =
          "'litter.csv' using (strcol('group') eq '" + group + "' ? column('cpu_seconds') : NaN):";
      const std::string style = " lc '" + std::string(colors[g]) + "' title '" + group + "'";
      if (g == 0) {
        body +=
            pick + "(column('" + name + "_interval')) with linespoints pt 7 ps 0.6 lw 1.6" + style;
      } else {
        const std::string difference = "abs(column('" + name + "_difference'))";
        const std::string interval = "column('" + name + "_difference_interval')";
        body += ", \\\n       " + pick + "(" + difference + "):(" + difference + "):(" +
                difference + " + " + interval + ") with yerrorbars pt 7 ps 0.7" + style;
      }
    }
    body += "\n";
  }
  body += "  unset multiplot\n";
  report.figure("litter", "Error of the litter's means against processor seconds", body, params,
                1300, 460);
}

}  // namespace

double interval_factor(std::int64_t runs) {
  const double z = 1.959963984540054, df = static_cast<double>(runs - 1);
  return z + (std::pow(z, 3) + z) / (4 * df) +
         (5 * std::pow(z, 5) + 16 * std::pow(z, 3) + 3 * z) / (96 * df * df);
}

void litter_section(Report& report) {
  const Options& options = report.options();
  const Params base = cold_litter(options.quick);
  const std::int64_t largest = options.quick ? 8 : 160, each = options.quick ? 4 : 40;
  const auto list = variations(options.quick);
  io::Progress progress("litter", static_cast<std::int64_t>(list.size()) + 2, options.quiet);
  std::int64_t done = 0;
  // Litters of the reference have seeds of their own, so that the others are independent of it.
  const Sample reference = sample_of(options, "reference", "default", base, 1000001, largest);
  progress.update(++done);
  std::vector<Sample> samples;
  const double begin = processor_seconds();
  const std::vector<Means> runs = run_litters(base, 1, largest, options.threads);
  const double spent = processor_seconds() - begin;
  progress.update(++done);
  for (std::int64_t n = options.quick ? 4 : 5; n <= largest; n *= 2) {
    samples.push_back(summary({"seeds", std::to_string(n) + " litters", base, 0, 0, {}, {}},
                              {runs.begin(), runs.begin() + n}));
    samples.back().cpu_seconds = spent * static_cast<double>(n) / static_cast<double>(largest);
  }
  for (const auto& [group, setting] : list) {
    samples.push_back(sample_of(options, group, setting.first, setting.second, 1, each));
    progress.update(++done);
  }
  report.heading("7. The litter: errors of means");
  report.text(
      "The whole litter is chaotic, so the error of a single run at a point in time says nothing "
      "(see below how fast two runs part). What a user reads off a run or a sweep are means: here "
      "those of Figure 2 at T_a = " +
      rounded(base.ta) + ", over steps " + std::to_string(base.discard) + " to " +
      std::to_string(base.steps) + ". The first row is the reference, " + std::to_string(largest) +
      " litters with the default settings; ± is half of a 95 % interval. Every other row is the "
      "difference from it, with the 95 % interval of that difference, in bold where the interval "
      "leaves out zero. Some one in twenty does so by chance. CPU seconds are those of the row's "
      "litters together.");
  write_csv(report, reference, samples);
  add_plot(report, base);
  add_table(report, reference, samples);
  report.text(verdict(reference, samples));
}

}  // namespace pupflow::report
