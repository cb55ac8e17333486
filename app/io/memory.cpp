#include "app/io/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// A small file of the system; empty where it cannot be read.
std::string system_file(const std::string& path) {
  try {
    return read_beginning(path, 1 << 14);
  } catch (const Failure&) {
    return {};
  }
}

/// The number behind `label` in `text`; kUnlimited where there is none.
std::uint64_t number_behind(std::string_view text, std::string_view label) {
  const std::size_t at = text.find(label);
  if (at == std::string_view::npos) return kUnlimited;
  text.remove_prefix(at + label.size());
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return read_number<std::uint64_t>(text.substr(0, text.find_first_not_of("0123456789")))
      .value_or(kUnlimited);
}

std::uint64_t difference(std::uint64_t limit, std::uint64_t taken) {
  if (limit == kUnlimited || taken == kUnlimited) return kUnlimited;
  return limit > taken ? limit - taken : 0;
}

std::uint64_t free_on_machine() {
  const std::string text = system_file("/proc/meminfo");
  const std::uint64_t free = number_behind(text, "MemAvailable:");
  const std::uint64_t swap = number_behind(text, "SwapFree:");
  if (free == kUnlimited) return kUnlimited;
  return 1024 * (free + (swap == kUnlimited ? 0 : swap));
}

std::uint64_t left_in_group() {
  std::string group = system_file("/proc/self/cgroup");  // "0::/path"
  if (!group.starts_with("0::")) return kUnlimited;
  group = "/sys/fs/cgroup" + group.substr(3, group.find('\n') - 3);
  return difference(number_behind(system_file(group + "/memory.max"), ""),
                    number_behind(system_file(group + "/memory.current"), ""));
}

std::string gigabytes(double bytes) {
  return formatted("%.2g GB", bytes / 1e9);
}

}  // namespace

std::uint64_t address_space_left() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
  const std::uint64_t pages = number_behind(system_file("/proc/self/statm"), "");
  if (pages == kUnlimited) return kUnlimited;
  return difference(limit.rlim_cur, pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
}

std::uint64_t memory_left() {
  return std::min({free_on_machine(), left_in_group(), address_space_left()});
}

void refuse_large(const std::string& what, double bytes, const std::string& right) {
  const auto left = static_cast<double>(memory_left());
  if (bytes <= left) return;
  refuse(what + " needs about " + gigabytes(bytes) + " of memory, of which " + gigabytes(left) +
         " are free; " + right);
}

}  // namespace pupflow::io
