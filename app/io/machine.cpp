#include "app/io/machine.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "pupflow/instruction_set.h"

namespace pupflow::io {
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
  return "clang " __clang_version__ ", " PUPFLOW_BUILD_TYPE " build";
#else
  return "g++ " __VERSION__ ", " PUPFLOW_BUILD_TYPE " build";
#endif
}

std::string kernel_words() {
  const auto sets = supported_instruction_sets();
  return std::string(instruction_set_name(sets.back())) + " (of " +
         joined(sets, ", ", instruction_set_name) + "; the results are the same)";
}

std::string cpu_name() {
  const std::string name = cpuinfo("model name");
  return name.empty() ? "unknown" : name;
}

std::string program_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  io::TextStream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string candidate = folder + "/" + name;
    if (folder.starts_with('/') && ::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return {};
}

}  // namespace pupflow::io
