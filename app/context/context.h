// Where an OpenGL context comes from, behind one small interface.
#pragma once

#include <string>
#include <vector>

namespace pupflow::context {

/// What came of looking for a context.
struct ContextReport {
  bool works = false;
  std::string chosen;              // e.g. "EGL surfaceless"
  std::string renderer, version;   // GL_RENDERER, GL_VERSION
  std::vector<std::string> tried;  // one line per attempt with its outcome
};

/// An OpenGL 3.3 core context with its functions loaded. Current on the making thread; destroyed
/// after everything that was made in it.
class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  virtual void make_current() = 0;

  /// Lets go of the calling thread, so that another one can make the context current.
  virtual void release_current() = 0;

  /// How it came about, e.g. "EGL surfaceless".
  virtual std::string name() const = 0;

 protected:
  Context() = default;
};

}  // namespace pupflow::context
