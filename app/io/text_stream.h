// Text written or read piece by piece.
#pragma once

#include <sstream>
#include <string>

namespace pupflow::io {

/// A std::stringstream that throws std::bad_alloc where memory ends. The plain one goes on without
/// what it could not hold.
class TextStream : public std::stringstream {
 public:
  explicit TextStream(const std::string& text = {}) : std::stringstream(text) {
    exceptions(std::ios::badbit);
  }
};

}  // namespace pupflow::io
