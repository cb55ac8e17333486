// What a sweep computes: a grid of parameter values, with several seeds at each point.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::study {

/// One varied parameter and its values.
struct Axis {
  const Parameter* parameter;
  std::vector<double> values;
};

/// Reads "name=from:to:count" (evenly spaced, both ends included) or "name=a,b,c". Throws
/// io::Failure(bad_input).
Axis parse_axis(const std::string& text);

/// Which runs one machine computes: those whose index leaves `number - 1` when divided by `of`.
struct Shard {
  std::int64_t number = 1, of = 1;
  bool whole() const { return of == 1; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads "i/n" with 1 <= i <= n. Throws io::Failure(bad_input).
Shard parse_shard(const std::string& text);

/// A sweep. Run number i has the grid point i / seeds (the last axis varies fastest).
struct Design {
  std::string name = "sweep";  // of its files: name.png, name.gp
  Params base;                 // everything that is not varied; base.seed is the base seed
  std::vector<Axis> axes;
  std::int64_t seeds = 10;
  Shard shard;

  std::int64_t points() const;
  std::int64_t runs() const { return points() * seeds; }

  /// The varied parameters' values at a grid point, one per axis.
  std::vector<double> values_at(std::int64_t point) const;

  /// Parameters of one run, its own seed included.
  Params params_of(std::int64_t run) const;

  /// The runs of the shard, in order.
  std::vector<std::int64_t> own_runs() const;
};

/// Throws io::Failure(bad_input) with every problem of the design: parameters that are invalid at
/// some grid point, a parameter varied twice, too many runs.
void check_design(const Design& design);

/// The manifest: a TOML text that holds everything the results depend on, and nothing else. Equal
/// texts mean equal results, to the byte.
std::string manifest_text(const Design& design);

/// Reads such a text back; `where` names it in errors. Throws io::Failure(bad_input).
Design parse_manifest(const std::string& text, const std::string& where);

}  // namespace pupflow::study
