#include "app/cli/machine.h"

#include <fstream>
#include <sstream>

namespace pupflow::cli {
namespace {

/// The value of the first line of /proc/cpuinfo that begins with `key`; empty when there is none.
std::string cpuinfo(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (!line.starts_with(key)) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

}  // namespace

std::string compiler_words() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string built_for() {
  std::string sets;
#if defined(__SSE2__)
  sets += " SSE2";
#endif
#if defined(__AVX2__)
  sets += " AVX2";
#endif
#if defined(__FMA__)
  sets += " FMA";
#endif
#if defined(__AVX512F__)
  sets += " AVX-512";
#endif
#if defined(__ARM_NEON)
  sets += " NEON";
#endif
  return sets.empty() ? "scalar" : sets.substr(1);
}

std::string cpu_name() {
  const std::string name = cpuinfo("model name");
  return name.empty() ? "unknown" : name;
}

std::vector<std::string> cpu_features() {
  std::string flags = cpuinfo("flags");            // x86
  if (flags.empty()) flags = cpuinfo("Features");  // ARM
  const std::pair<std::string, std::string> wanted[] = {{"sse2", "SSE2"},
                                                        {"avx2", "AVX2"},
                                                        {"fma", "FMA"},
                                                        {"avx512f", "AVX-512"},
                                                        {"asimd", "NEON"}};
  std::vector<std::string> found;
  std::istringstream words(flags);
  for (std::string word; words >> word;) {
    for (const auto& [flag, name] : wanted) {
      if (word == flag) found.push_back(name);
    }
  }
  return found;
}

}  // namespace pupflow::cli
