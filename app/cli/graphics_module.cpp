#include "app/cli/graphics_module.h"

#include "app/cli/module.h"
#include "app/io/failure.h"

namespace pupflow::cli {
namespace {

constexpr const char* kPackages =
    "Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri libglew2.2 libglfw3";

}  // namespace

graphics::Graphics& load_graphics() {
  const Module module = load_module(kGraphicsModule, graphics::kEntry);
  if (!module.entry) {
    throw io::Failure(io::ExitCode::no_context,
                      "no graphics: " + module.problem + " (" + kPackages + ")");
  }
  return *reinterpret_cast<graphics::Entry>(module.entry)();
}

}  // namespace pupflow::cli
