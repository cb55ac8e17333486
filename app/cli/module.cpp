#include "app/cli/module.h"

#include <filesystem>

namespace pupflow::cli {

namespace fs = std::filesystem;

std::vector<std::string> module_candidates(const std::string& file) {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  return {(folder / file).string(),
          (folder / PUPFLOW_MODULE_FOLDER / file).lexically_normal().string()};
}

io::Module load_module(const std::string& file, const char* entry) {
  try {
    return io::load_module(module_candidates(file), entry);
  } catch (const fs::filesystem_error& error) {
    return {nullptr, std::string("the module cannot be found: ") + error.what(), true};
  }
}

}  // namespace pupflow::cli
