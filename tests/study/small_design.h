// Sweeps that take milliseconds.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study::test {

/// Three pups of 54 points for 60 steps.
inline Params small_litter() {
  Params params;
  params.pups = 3;
  params.face_points = 3;
  params.steps = 60;
  params.discard = 20;
  return params;
}

inline Design small_design(const std::vector<std::string>& vary, std::int64_t seeds) {
  Design design;
  design.base = small_litter();
  for (const std::string& axis : vary) design.axes.push_back(parse_axis(axis));
  design.seeds = seeds;
  return design;
}

/// A row whose observables are value, value + 1, ...
inline Row row_of(std::int64_t run, double value) {
  Row row;
  row.run = run;
  row.means = {value, value + 1, value + 2, value + 3, value + 4, value + 5};
  row.exposed_sd = value + 6;
  return row;
}

inline Row bad_row(std::int64_t run) {
  RunResult result;
  result.status = {Status::Kind::diverged, Stage::shape_match, 12, 1, 7};
  return make_row(run, result);
}

/// As `row_of`, but of a run in which pups stood outside the wall and then hung.
inline Row warned_row(std::int64_t run, double value) {
  RunResult result;
  result.warnings.add({Warning::Kind::outside, 74, 4});
  result.warnings.add({Warning::Kind::hanging, 150, 2});
  Row row = row_of(run, value);
  row.status = make_row(run, result).status;
  return row;
}

}  // namespace pupflow::study::test
