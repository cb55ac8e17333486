#include "app/cli/outputs.h"

#include <filesystem>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"

namespace pupflow::cli {
namespace {

namespace fs = std::filesystem;

/// One spelling for every way to name a file.
fs::path resolved(const std::string& path) {
  std::error_code unresolved;  // then opening the file will tell
  return fs::weakly_canonical(fs::absolute(path, unresolved), unresolved);
}

bool are_same(const std::string& one, const std::string& other) {
  if (io::is_standard_output(one) && io::is_standard_output(other)) return true;
  std::error_code not_there;
  const bool same = resolved(one) == resolved(other) || fs::equivalent(one, other, not_there);
  return same && !io::is_stream(one);
}

}  // namespace

void refuse_same_file(const std::vector<Output>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Output &one = outputs[j], &other = outputs[i];
      if (one.path.empty() || other.path.empty() || !are_same(one.path, other.path)) continue;
      io::refuse(one.option + " and " + other.option + " both go to " + one.path +
                 "; name two files");
    }
  }
}

}  // namespace pupflow::cli
