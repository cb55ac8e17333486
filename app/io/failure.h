// How the program fails: one line for people and an exit code for scripts.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "app/io/text.h"

namespace pupflow::io {

enum class ExitCode {
  done = 0,
  difference = 1,    // verify: a file is not what its run gives
  bad_input = 2,     // the command line, a scene or a parameter is wrong
  bad_numbers = 3,   // a simulation's numbers went wrong
  bad_file = 4,      // a file could not be read or written
  no_context = 5,    // no OpenGL context could be made
  interrupted = 130  // Ctrl-C
};

/// Thrown anywhere in the program, caught once in main(), which prints lines() on standard error and
/// exits with code(). what() says what is wrong, where, and what would be right; NUL does not end it.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& message)
      : std::runtime_error(printable(message, "\n")), code_(code) {}

  /// Several problems, a line each.
  Failure(ExitCode code, const std::vector<std::string>& problems)
      : std::runtime_error(
            joined(problems, "\n", [](const auto& text) { return printable(text); })),
        code_(code),
        several_(true) {}

  /// what() as it is shown: line breaks in paths and values begin no line.
  std::string lines() const { return several_ ? what() : printable(what()); }
  bool several() const { return several_; }
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
  bool several_ = false;
};

/// Throws Failure(bad_input).
[[noreturn]] inline void refuse(const std::string& message) {
  throw Failure(ExitCode::bad_input, message);
}

/// The same with a line for each problem; does nothing where there is none.
inline void refuse_all(const std::vector<std::string>& problems) {
  if (!problems.empty()) throw Failure(ExitCode::bad_input, problems);
}

}  // namespace pupflow::io
