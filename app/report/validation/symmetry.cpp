#include "app/report/validation/symmetry.h"

#include <algorithm>
#include <cmath>

#include "app/report/statistics.h"
#include "app/report/validation/sections.h"
#include "engine/bodies.h"
#include "engine/rng.h"
#include "pupflow/geometry.h"

namespace pupflow::report {
namespace {

void copy_temperature_and_heading(const LitterView& from, int source, Simulation& to, int pup,
                                  double sign) {
  to.set_body_temperature(pup, from.tb[source]);
  to.set_heading(pup, sign * from.heading[source]);
}

/// For each point of a rest shape the one in its place after the mirror that changes two axes of
/// the cube, chosen so that the first point keeps its place.
std::vector<std::size_t> mirror_of_rest(const Params& params) {
  const Points rest = cube_sphere(params.face_points, 1);
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}}) {
    for (const double sign : {1.0, -1.0}) {
      const auto image = [&, a = a, b = b](Eigen::Vector3d p) {
        std::swap(p[a], p[b]);
        p[a] *= sign;
        p[b] *= sign;
        return p;
      };
      if ((image(rest[0]) - rest[0]).norm() > 1e-9) continue;
      std::vector<std::size_t> partner;
      for (const Eigen::Vector3d& point : rest) {
        const Eigen::Vector3d wanted = image(point);
        const auto nearest = std::min_element(rest.begin(), rest.end(), [&](auto& p, auto& q) {
          return (p - wanted).squaredNorm() < (q - wanted).squaredNorm();
        });
        partner.push_back(static_cast<std::size_t>(nearest - rest.begin()));
      }
      return partner;
    }
  }
  return {};  // never: the first point is on a diagonal of a face
}

Points through_mirror(const Points& points, const std::vector<std::size_t>& partner) {
  Points image;
  for (const std::size_t i : partner)
    image.emplace_back(points[i].x(), -points[i].y(), points[i].z());
  return image;
}

/// The litter after 400 steps: on the floor, most pups in contact.
Simulation settled(const Params& params) {
  Simulation simulation(params);
  while (simulation.steps_done() < 400) step_on(simulation);
  return simulation;
}

/// Means over the steps after `discard` of a run from the start of `params`, or from its mirror
/// image: run_statistics(), then two numbers that a mirror reverses: the mean over pups of
/// r_x v_y - r_y v_x of centres, and the rate at which headings turn.
std::vector<double> measure_turning(const Params& params, bool in_mirror) {
  Simulation simulation(params);
  if (in_mirror) simulation = mirrored(simulation);
  RunMeans means(params.discard);
  Observer observer(simulation);
  double round = 0, turned = 0, count = 0;
  std::vector<Eigen::Vector3d> centres(params.pups);
  std::vector<double> headings(params.pups);
  while (simulation.steps_done() < params.steps) {
    for (int pup = 0; pup < params.pups; ++pup) {
      centres[pup] = simulation.view().positions.mean(pup);
      headings[pup] = simulation.view().heading[pup];
    }
    step_on(simulation);
    means.add(simulation, observer.observe(simulation));
    if (simulation.steps_done() <= params.discard) continue;
    for (int pup = 0; pup < params.pups; ++pup) {
      const Eigen::Vector3d now = simulation.view().positions.mean(pup);
      round += (centres[pup].x() * now.y() - centres[pup].y() * now.x()) / params.dt;
      turned +=
          std::remainder(simulation.view().heading[pup] - headings[pup], 2 * M_PI) / params.dt;
      ++count;
    }
  }
  std::vector<double> numbers = statistics_of(means);
  numbers.insert(numbers.end(), {round / count, turned / count});
  return numbers;
}

std::string steps_text(std::vector<double> steps, std::int64_t most) {
  std::sort(steps.begin(), steps.end());
  const auto text = [&](double s) {
    return s > static_cast<double>(most) ? "over " + std::to_string(most) : rounded(s, 4);
  };
  return text(steps[steps.size() / 2]) + " (" + text(steps.front()) + " … " + text(steps.back()) +
         ")";
}

/// Steps until these diverge: a litter on the floor and the same with other pup numbers; both above
/// the floor; a litter on the floor and its mirror image.
std::vector<double> partings(const Params& params, std::int64_t most) {
  const Simulation down = settled(params), up = lifted(down);
  const Expected renumbered = [](const Simulation& a, int pup) {
    return a.view().positions.mean(pup_before(pup, a.pups()));
  };
  const Expected image = [](const Simulation& a, int pup) {
    const Eigen::Vector3d c = a.view().positions.mean(pup);
    return Eigen::Vector3d(c.x(), -c.y(), c.z());
  };
  const std::int64_t steps[] = {steps_until_apart(down, relabelled(down), renumbered, most),
                                steps_until_apart(up, relabelled(up), renumbered, most),
                                steps_until_apart(down, mirrored(down), image, most)};
  return {std::begin(steps), std::end(steps)};
}

void partings_table(Report& report) {
  const Options& options = report.options();
  const std::int64_t most = options.quick ? 50 : 1000;
  std::vector<Params> settings(2);
  settings[0].ambient_temperature = settings[1].ambient_temperature = 0.2;
  settings[1].heading = Heading::body;
  const auto runs = all_runs("partings", settings, options.quick ? 2 : 7, options,
                             [&](const Params& params) { return partings(params, most); });
  const char* const titles[] = {"other numbers, on the floor", "other numbers, in the air",
                                "mirrored, on the floor"};
  const char* const columns[] = {"numbers_floor", "numbers_air", "mirror_floor"};
  io::CsvFile csv = report.csv("partings", settings[0], "heading,change,seed,steps");
  std::vector<io::Row> rows{{"steps until apart", "course", "body"}};
  for (std::size_t change = 0; change < std::size(titles); ++change) {
    rows.push_back({titles[change]});
    for (std::size_t i = 0; i < settings.size(); ++i) {
      rows.back().push_back(steps_text(runs[i][change], most));
      for (std::size_t seed = 0; seed < runs[i][change].size(); ++seed) {
        csv.cell(i == 0 ? "course" : "body").cell(columns[change]);
        csv.cell(static_cast<std::int64_t>(seed) + 1).cell(runs[i][change][seed]).end_row();
      }
    }
  }
  csv.commit();
  report.table(rows);
}

void means_table(Report& report) {
  const Options& options = report.options();
  const std::size_t seeds = options.quick ? 2 : 20;
  std::vector<Params> settings(2);
  settings[0].ambient_temperature = settings[1].ambient_temperature = 0.2;
  settings[1].heading = Heading::body;
  std::vector<std::vector<std::vector<double>>> runs[2];
  for (const bool in_mirror : {false, true}) {
    runs[in_mirror ? 1 : 0] =
        all_runs(in_mirror ? "mirrored" : "not mirrored", settings, static_cast<int>(seeds),
                 options, [&](const Params& p) { return measure_turning(p, in_mirror); });
  }
  io::Row titles;
  add_statistic_labels(titles);
  titles.insert(titles.end(), {"circulation in the arena", "turning, rad/s"});
  std::vector<std::string> names = statistic_names();
  names.insert(names.end(), {"circulation", "turning"});
  io::CsvFile csv = report.csv("mirror", settings[0],
                               "heading,statistic,mean,mean_se,mirrored,mirrored_se,difference,"
                               "difference_se");
  std::vector<io::Row> rows{{"heading", "", "not mirrored", "mirrored", "difference"}};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string heading = i == 0 ? "course" : "body";
    for (std::size_t n = 0; n < names.size(); ++n) {
      std::vector<double> difference(seeds);
      for (std::size_t s = 0; s < seeds; ++s) difference[s] = runs[1][i][n][s] - runs[0][i][n][s];
      const MeanAndError all[] = {mean_and_error(runs[0][i][n]), mean_and_error(runs[1][i][n]),
                                  mean_and_error(difference)};
      csv.cell(std::string_view(heading)).cell(names[n]);
      rows.push_back({heading, titles[n]});
      for (const MeanAndError& e : all) {
        csv.cell(e.mean).cell(e.error);
        rows.back().push_back(text_of(e));
      }
      csv.end_row();
    }
  }
  csv.commit();
  report.table(rows);
}

}  // namespace

int pup_before(int pup, int pups) {
  return (5 * pup + 3) % pups;
}

Simulation relabelled(const Simulation& simulation) {
  Simulation other(simulation.params());
  const LitterView from = simulation.view();
  for (int pup = 0; pup < simulation.pups(); ++pup) {
    const int source = pup_before(pup, simulation.pups());
    place(other, pup, of_pup(from.positions, source), of_pup(from.velocities, source));
    copy_temperature_and_heading(from, source, other, pup, 1);
  }
  return other;
}

Simulation mirrored(const Simulation& simulation) {
  Simulation other(simulation.params());
  const LitterView from = simulation.view();
  const std::vector<std::size_t> partner = mirror_of_rest(simulation.params());
  for (int pup = 0; pup < simulation.pups(); ++pup) {
    place(other, pup, through_mirror(of_pup(from.positions, pup), partner),
          through_mirror(of_pup(from.velocities, pup), partner));
    copy_temperature_and_heading(from, pup, other, pup, -1);
  }
  return other;
}

Simulation lifted(const Simulation& simulation) {
  Simulation other = simulation;
  const LitterView from = simulation.view();
  Rng random(1);
  for (int pup = 0; pup < simulation.pups(); ++pup) {
    const Eigen::Vector3d up(0, 0, random.uniform(3, 3.001));
    place(other, pup, shifted(of_pup(from.positions, pup), up), of_pup(from.velocities, pup));
  }
  return other;
}

std::int64_t steps_until_apart(Simulation a, Simulation b, const Expected& expected,
                               std::int64_t most) {
  for (std::int64_t step = 1; step <= most; ++step) {
    step_on(a);
    step_on(b);
    for (int pup = 0; pup < a.pups(); ++pup) {
      if ((b.view().positions.mean(pup) - expected(a, pup)).norm() > 1e-6) return step;
    }
  }
  return most + 1;
}

void symmetry_section(Report& report) {
  report.heading("Pup numbers and mirrors");
  report.text(
      "All points that stand on the floor are at exactly the same height. Where two of them touch, "
      "the point of the pup with the lower number counts as the upper one and is moved, so other "
      "pup numbers give another run. With heading = body the first point of a pup always lies on "
      "the line between left and right and counts as right, so a litter and its mirror image "
      "differ. The table shows the number of steps after which the centre of a pup is more than "
      "10⁻⁶ from its expected place: the median over seeds, the minimum and the maximum. T_a = "
      "0.2, from step 400 on, when the litter is on the floor. In the air (lifted by 3, each pup "
      "by up to 0.001 more) no two points are at the same height.");
  partings_table(report);
  report.text(
      "Means over steps 501 to 1500 of litters from the start and from its mirror image. A start "
      "is as likely as its mirror image, so all means but the last two can differ only by chance. "
      "A mirror reverses the last two, so they would be 0 up to chance if the model were symmetric "
      "under reflection.");
  means_table(report);
}

}  // namespace pupflow::report
