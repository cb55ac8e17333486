#include "app/report/stability/axes.h"

#include <algorithm>
#include <cmath>

#include "app/report/report.h"

namespace pupflow::report {

Values evenly(double from, double to, int count) {
  Values values;
  for (int i = 0; i < count; ++i) {
    values.push_back(std::stod(rounded(from + (to - from) * i / (count - 1), 4)));
  }
  return values;
}

Values decades(int from, int to, int per_decade) {
  Values values;
  for (int i = from * per_decade; i <= to * per_decade; ++i) {
    const double value = std::pow(10, static_cast<double>(i) / per_decade);
    values.push_back(std::stod(rounded(value, 3)));
  }
  return values;
}

MapAxis along(const std::string& parameter, const std::string& label, bool log, Values values) {
  const Parameter& row = *find_parameter(parameter);
  return {parameter, label, log, std::move(values), row.min, row.max, row.get, row.set};
}

MapAxis alpha_axis(bool quick) {
  return along("alpha", "rigidity α", false, quick ? Values{0.1, 0.7, 1} : evenly(0, 1, 11));
}

MapAxis step_axis(bool quick) {
  return along("dt", "time step h", true, quick ? Values{0.001, 0.01, 0.1, 1} : decades(-3, 0, 4));
}

MapAxis pups_axis(bool quick) {
  return along("pups", "pups N", true, quick ? Values{1, 4, 12} : Values{1, 2, 4, 6, 12, 24, 48});
}

MapAxis point_axis(bool quick) {
  return {"point_over_pup",
          "r_{point} / r_{pup}",
          true,
          quick ? Values{0.05, 0.2, 1.6} : Values{0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6},
          0,
          1e6,
          [](const Params& p) { return p.point_radius / p.pup_radius; },
          [](Params& p, double ratio) { p.point_radius = ratio * p.pup_radius; }};
}

MapAxis pup_axis(bool quick) {
  return {"pup_over_arena",
          "r_{pup} / r_{arena}",
          true,
          quick ? Values{0.02, 0.125, 0.8}
                : Values{0.01, 0.02, 0.04, 0.0625, 0.125, 0.25, 0.4, 0.6, 0.8},
          0,
          1,
          [](const Params& p) { return p.pup_radius / p.arena_radius; },
          [](Params& p, double ratio) {
            const double point_over_pup = p.point_radius / p.pup_radius;
            p.pup_radius = ratio * p.arena_radius;
            p.point_radius = point_over_pup * p.pup_radius;
            const double room = p.arena_radius - p.pup_radius - p.point_radius;
            p.start_spread = std::min(p.start_spread, std::max(room, 0.0) / 2);
          }};
}

}  // namespace pupflow::report
