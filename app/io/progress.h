// Progress of long work: a bar with the time left on a terminal, plain lines otherwise.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace pupflow::io {

/// Reports on standard error. Silent when `quiet`, and for work that ends within a second.
class Progress {
 public:
  Progress(std::string what, std::int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` units are finished. Cheap: prints at most ten times a second on a terminal,
  /// and at each tenth of the work elsewhere.
  void update(std::int64_t done);

 private:
  void print(std::int64_t done, bool last);
  std::string what_;
  std::int64_t total_;
  std::int64_t done_ = 0;
  bool quiet_, terminal_, shown_ = false;
  int tenths_ = 0;
  std::chrono::steady_clock::time_point start_, printed_;
};

}  // namespace pupflow::io
