// Repeats the run behind an output of this program and compares.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace pupflow::verify {

struct Options {
  int threads = 1;
  bool quiet = false;               // no progress
  std::optional<std::int64_t> row;  // of a table of runs: only this one; 1 is the first
};

/// What came of it: "1500 steps, 1500 rows", or where the file and the run first differ.
struct Verdict {
  bool same;
  std::string words;
};

/// Repeats what `path` shows: a metrics or pups CSV, a table of runs or the folder of a sweep, a
/// checkpoint, a picture of render, figure1 or the window. Throws io::Failure: bad_input when the
/// file does not hold all that made it, bad_file, interrupted.
Verdict verify(const std::string& path, const Options& options);

}  // namespace pupflow::verify
