// What came of looking for an OpenGL context.
#pragma once

#include <string>
#include <vector>

namespace pupflow::context {

struct ContextReport {
  bool works = false;
  std::string chosen;              // e.g. "EGL surfaceless"
  std::string renderer, version;   // GL_RENDERER, GL_VERSION
  std::vector<std::string> tried;  // one line per attempt with its outcome
};

}  // namespace pupflow::context
