// How a file is verified, and what comes of it.
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

}  // namespace pupflow::verify
