#include "app/io/module.h"

#include <dlfcn.h>

#include <filesystem>

#include "app/io/text.h"

namespace pupflow::io {

Module load_module(const std::vector<std::string>& candidates, const char* entry) {
  Module found;
  for (const std::string& path : candidates) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) continue;
    // Never closed: what it hands out lives as long as the program.
    void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module) found.entry = ::dlsym(module, entry);
    if (!found.entry) found.problem = ::dlerror();
    return found;
  }
  found.missing = true;
  found.problem = "the module is neither " + joined(candidates, " nor ");
  return found;
}

}  // namespace pupflow::io
