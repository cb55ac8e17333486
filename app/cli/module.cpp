#include "app/cli/module.h"

#include <sys/auxv.h>

namespace pupflow::cli {

namespace fs = std::filesystem;

fs::path program_folder() {
  std::error_code failed;
  fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) {  // no /proc here: the path that the program was started by
    program = fs::canonical(reinterpret_cast<const char*>(::getauxval(AT_EXECFN)));
  }
  return program.parent_path();
}

std::vector<std::string> module_candidates(const std::string& file) {
  const fs::path folder = program_folder();
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
