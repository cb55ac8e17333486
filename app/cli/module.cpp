#include "app/cli/module.h"

#include <dlfcn.h>

#include <filesystem>

namespace pupflow::cli {

namespace fs = std::filesystem;

std::vector<std::string> module_candidates(const std::string& file) {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  return {(folder / file).string(),
          (folder / PUPFLOW_MODULE_FOLDER / file).lexically_normal().string()};
}

Module load_module(const std::string& file, const char* entry) {
  Module found;
  std::string looked;
  try {
    for (const std::string& path : module_candidates(file)) {
      std::error_code ignored;
      if (!fs::exists(path, ignored)) {
        looked += (looked.empty() ? "" : " nor ") + path;
        continue;
      }
      // Never closed: what it hands out lives as long as the program.
      void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
      if (module) found.entry = ::dlsym(module, entry);
      if (!found.entry) found.problem = ::dlerror();
      return found;
    }
  } catch (const fs::filesystem_error& error) {
    looked = error.what();
  }
  found.missing = true;
  found.problem = "the module is neither " + looked;
  return found;
}

}  // namespace pupflow::cli
