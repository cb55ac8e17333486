#include "app/cli/graphics_module.h"

#include <dlfcn.h>

#include <filesystem>

#include "app/io/failure.h"

namespace pupflow::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModule = "libpupflow_graphics.so";
constexpr const char* kPackages =
    "Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri libglew2.2 libglfw3";

io::Failure no_module(const std::string& reason) {
  return {io::ExitCode::no_context, "no graphics: " + reason + " (" + kPackages + ")"};
}

fs::path executable_folder() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) throw no_module("/proc/self/exe: " + error.message());
  return self.parent_path();
}

}  // namespace

std::vector<std::string> module_candidates() {
  const fs::path folder = executable_folder();
  return {(folder / kModule).string(),
          (folder / PUPFLOW_MODULE_FOLDER / kModule).lexically_normal().string()};
}

pictures::Graphics& load_graphics() {
  std::string looked;
  for (const std::string& path : module_candidates()) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
      looked += (looked.empty() ? "" : " nor ") + path;
      continue;
    }
    // Never closed: what it hands out lives as long as the program.
    void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) throw no_module(::dlerror());
    const auto entry =
        reinterpret_cast<pictures::GraphicsEntry>(::dlsym(module, pictures::kGraphicsEntry));
    if (!entry) throw no_module(::dlerror());
    return *entry();
  }
  throw no_module("the module is neither " + looked);
}

}  // namespace pupflow::cli
