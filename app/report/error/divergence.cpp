// How fast two litters diverge that start 1e-9 from each other.
#include <algorithm>
#include <cmath>

#include "app/io/progress.h"
#include "app/report/error/litter.h"
#include "engine/bodies.h"

namespace pupflow::report {
namespace {

constexpr double kPush = 1e-9;

/// Root mean square distance between the points of two litters.
double distance(const Simulation& a, const Simulation& b) {
  double sum = 0;
  int count = 0;
  for (int pup = 0; pup < a.pups(); ++pup) {
    const Points one = of_pup(a.view().positions, pup), other = of_pup(b.view().positions, pup);
    for (std::size_t i = 0; i < one.size(); ++i, ++count) sum += (one[i] - other[i]).squaredNorm();
  }
  return std::sqrt(sum / count);
}

/// The distance after every tenth step, beginning with the start.
std::vector<double> distances(const Params& params, int samples, io::Progress& progress,
                              std::int64_t& done) {
  Simulation one(params);
  Simulation other = one;
  const LitterView start = one.view();
  place(other, 0, shifted(of_pup(start.positions, 0), {kPush, 0, 0}), of_pup(start.velocities, 0));
  std::vector<double> apart{distance(one, other)};
  for (int i = 0; i < samples; ++i) {
    stop_if_interrupted();
    one.run(10);
    other.run(10);
    apart.push_back(distance(one, other));
    progress.update(++done);
  }
  return apart;
}

/// How the distance of two litters grows.
struct Growth {
  double steepest = 0;  // per second, over the half second in which ln of the distance grows most
  double mean = 0;      // per second, from the first growth to a hundredth of a radius
  double visible = std::nan("");  // model seconds until the distance is a hundredth of a radius
};

Growth growth_of(const std::vector<double>& apart, const Params& params) {
  Growth growth;
  const double sample = 10 * params.dt, limit = params.pup_radius / 100;
  std::size_t begin = 0, end = 0;
  while (begin + 1 < apart.size() && apart[begin + 1] < 2 * apart[0]) ++begin;
  end = begin;
  while (end + 1 < apart.size() && apart[end] < limit) ++end;
  if (apart[end] >= limit) growth.visible = static_cast<double>(end) * sample;
  const double seconds = std::max(1.0, static_cast<double>(end - begin)) * sample;
  growth.mean = std::log(apart[end] / apart[begin]) / seconds;
  for (std::size_t i = 0; i + 5 <= end; ++i) {
    growth.steepest = std::max(growth.steepest, std::log(apart[i + 5] / apart[i]) / (5 * sample));
  }
  return growth;
}

}  // namespace

void divergence_section(Report& report) {
  const Options& options = report.options();
  const int samples = options.quick ? 40 : 150, litters = options.quick ? 2 : 5;
  Params params;
  params.ambient_temperature = 0.2;
  io::Progress progress("divergence", std::int64_t{samples} * litters, options.quiet);
  std::int64_t done = 0;
  io::CsvFile csv = report.csv("divergence", params, "seed,time,distance");
  std::vector<io::Row> rows{
      {"seed", "growth at its fastest, 1/s", "growth on average, 1/s", "distance r_pup/100 after"}};
  double mean = 0, shortest = std::nan("");
  for (int seed = 1; seed <= litters; ++seed) {
    params.seed = seed;
    const std::vector<double> apart = distances(params, samples, progress, done);
    for (std::size_t i = 0; i < apart.size(); ++i) {
      csv.cell(std::int64_t{seed}).cell(10 * params.dt * static_cast<double>(i));
      csv.cell(apart[i]).end_row();
    }
    const Growth growth = growth_of(apart, params);
    mean += growth.mean / litters;
    shortest = std::fmin(shortest, growth.visible);
    rows.push_back(
        {std::to_string(seed), rounded(growth.steepest), rounded(growth.mean),
         std::isfinite(growth.visible) ? rounded(growth.visible) + " s" : "later than the run"});
  }
  csv.commit();
  report.heading("8. The litter: how fast two runs diverge");
  report.text(
      "Pairs of litters at T_a = 0.2. In one of each pair the first pup starts 10⁻⁹ further along "
      "x. The distance is the root mean square distance of their points.");
  std::string body =
      "  set logscale y\n  set format y '10^{%L}'\n  set xlabel 'model seconds'\n  set ylabel "
      "'distance'\n  set grid lc '#dddddd'\n  set key bottom right\n  plot ";
  for (int seed = 1; seed <= litters; ++seed) {
    const std::string text = std::to_string(seed);
    body += std::string(seed == 1 ? "" : ", \\\n       ") +
            "'divergence.csv' using (column('seed') == " + text +
            " ? column('time') : NaN):(column('distance')) with lines lw 1.6 title 'seed " + text +
            "'";
  }
  report.figure("divergence", "Distance of two litters that start 1e-9 apart", body + "\n", params);
  report.table(rows);
  // From the last digit of a double (1e-16 of the arena) to a hundredth of a radius.
  const double rounding = std::log(params.pup_radius / 100 / 1e-16) / mean;
  report.text("On average a difference grows by a factor e in " + rounded(1 / mean, 2) +
              " s once the pups touch. **What this means:** after about " + rounded(rounding, 2) +
              " model seconds of contact even two runs that differ by the rounding of one double "
              "are two different litters. So compare means over seeds, never single runs with "
              "different settings, precision or step, and do not use the path of one litter as a "
              "prediction. The same parameters and seed give the same bits on every machine that "
              "this program runs on.");
}

}  // namespace pupflow::report
