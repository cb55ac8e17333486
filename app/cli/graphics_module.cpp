#include "app/cli/graphics_module.h"

#include "app/cli/module.h"

namespace pupflow::cli {

graphics::Graphics& load_graphics() {
  return graphics::entered(load_module(io::kGraphicsModule, graphics::kEntry));
}

}  // namespace pupflow::cli
