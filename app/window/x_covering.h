// Whether other windows cover this one, as the X server says it.
#pragma once

#include <memory>

struct GLFWwindow;

namespace pupflow::window {

/// Asks the X server by a connection of its own. Elsewhere, and under a compositor, which keeps what is
/// covered, no window ever counts as covered.
class Covering {
 public:
  explicit Covering(GLFWwindow* window);
  ~Covering();
  Covering(const Covering&) = delete;
  Covering& operator=(const Covering&) = delete;

  /// Whether no pixel of the window can be seen.
  bool whole();

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;  // none: it cannot be told
  bool whole_ = false;
};

}  // namespace pupflow::window
