#include "app/io/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pupflow::io {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// "42 s", "3 min 05 s" or "2 h 07 min".
std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  char text[48];
  if (whole < 60) {
    std::snprintf(text, sizeof text, "%lld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof text, "%lld min %02lld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld h %02lld min", whole / 3600, whole / 60 % 60);
  }
  return text;
}

}  // namespace

Progress::Progress(std::string what, std::int64_t total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      printed_(start_) {}

Progress::~Progress() {
  if (shown_) print(done_, true);
}

void Progress::update(std::int64_t done) {
  done_ = done;
  if (quiet_ || total_ <= 0) return;
  const Clock::time_point now = Clock::now();
  if (now - start_ < std::chrono::seconds(1)) return;
  if (terminal_) {
    if (now - printed_ < std::chrono::milliseconds(100)) return;
  } else {
    const int tenths =
        static_cast<int>(10 * static_cast<double>(done) / static_cast<double>(total_));
    if (tenths == tenths_) return;
    tenths_ = tenths;
  }
  printed_ = now;
  shown_ = true;
  print(done, false);
}

void Progress::print(std::int64_t done, bool last) {
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  const double spent = Seconds(Clock::now() - start_).count();
  std::string end;
  if (last) {
    end = duration_text(spent);
  } else if (share > 0) {
    end = duration_text(spent * (1 - share) / share) + " left";
  }
  char line[256];
  if (terminal_) {
    constexpr int kCells = 30;
    const int full = static_cast<int>(share * kCells);
    const std::string bar = std::string(full, '#') + std::string(kCells - full, '.');
    std::snprintf(line, sizeof line, "\r%s [%s] %3.0f %%  %s\x1b[K%s", what_.c_str(), bar.c_str(),
                  100 * share, end.c_str(), last ? "\n" : "");
  } else {
    if (last) return;
    std::snprintf(line, sizeof line, "%s: %lld of %lld, %s\n", what_.c_str(),
                  static_cast<long long>(done), static_cast<long long>(total_), end.c_str());
  }
  std::fputs(line, stderr);
  std::fflush(stderr);
}

}  // namespace pupflow::io
