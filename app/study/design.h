// What a sweep computes: points, each a value of every varied parameter, with several seeds at each.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/study/axis.h"
#include "pupflow/parameters.h"

namespace pupflow::study {

/// What a sweep may be called, and so its figure.
inline constexpr std::array<std::string_view, 2> kDesignNames{"sweep", "figure2"};

/// Which runs one machine computes: those whose index leaves `number - 1` when divided by `of`.
struct Shard {
  std::int64_t number = 1, of = 1;
  bool whole() const { return of == 1; }
  /// How many of `runs` runs are its own.
  std::int64_t count(std::int64_t runs) const { return (runs - number + of) / of; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads "i/n" with 1 <= i <= n. Throws io::Failure(bad_input), which says where the text stood.
Shard parse_shard(const std::string& text, const std::string& where = "--shard");

/// How points are made of the values of the axes.
enum class Layout {
  grid,   // every combination of values; the last axis varies fastest
  table,  // point i has value number i of each axis, which is a column of a file (table.h)
  latin   // the same, with values that spread_latin made (latin.h)
};

/// Seeds are numbered in blocks of so many: see Design::number_of.
constexpr std::int64_t kSeedBlock = 10;

/// A sweep. Run number i is at point i / seeds.
struct Design {
  std::string name = "sweep";  // of its files: name.png, name.gp
  Params base;                 // everything that is not varied; base.seed is the base seed
  Layout layout = Layout::grid;
  std::vector<Axis> axes;
  std::vector<std::string> spans;         // of a latin hypercube: the ranges of its axes
  std::int64_t seeds = 10;                // at each point; 1 where seeds are given
  std::int64_t seed_block = kSeedBlock;   // `seeds` in files of older versions
  std::vector<std::int64_t> given_seeds;  // of a table with a column `seed`: that of each point
  std::int64_t record_every = 0;          // steps from row to row of a run's series; 0: no series
  Shard shard;

  std::int64_t points() const;
  std::int64_t runs() const { return points() * seeds; }

  /// The varied parameters' values at a point, one per axis.
  std::vector<double> values_at(std::int64_t point) const;

  /// A number of a run that stays the same when seeds are added: the first seed_block seeds of all
  /// points come first, then the next, and so on. Equal to the run's index where seeds = seed_block.
  std::int64_t number_of(std::int64_t run) const;

  /// The run of such a number; nothing when the design has none.
  std::optional<std::int64_t> run_of(std::int64_t number) const;

  /// The seed of a run: the one given, or run_seed of the base seed and the run's number.
  std::int64_t seed_of(std::int64_t run) const;

  /// Parameters of one run, its own seed included.
  Params params_of(std::int64_t run) const;

  /// The runs of the shard, in order: how many, the one at `place`, all of them.
  std::int64_t own_count() const { return shard.count(runs()); }
  std::int64_t own_run(std::int64_t place) const { return shard.number - 1 + place * shard.of; }
  std::vector<std::int64_t> own_runs() const;
};

/// What is wrong with the parameters of a run of a sweep, a sentence each.
std::vector<std::string> run_problems(const Params& params);

/// Throws io::Failure(bad_input) with every problem of the design: parameters that are invalid at
/// some point, a parameter varied twice, too many runs.
void check_design(const Design& design);

/// The manifest: a TOML text that holds everything the results depend on, and nothing else; of a
/// table it holds a hash. Equal texts mean equal results, to the byte.
std::string manifest_text(const Design& design);

/// Reads such a text back; `where` names it in errors. The table of a design is read from `table`.
/// Throws io::Failure: bad_input, also when the table has another hash; bad_file when it cannot be
/// read.
Design parse_manifest(const std::string& text, const std::string& where,
                      const std::string& table = "");

}  // namespace pupflow::study
