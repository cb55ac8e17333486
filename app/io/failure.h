// How the program fails: one line for people and an exit code for scripts.
#pragma once

#include <stdexcept>
#include <string>

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

/// Thrown anywhere in the program, caught once in main(), which prints what() as one line on
/// standard error and exits with code(). what() says what is wrong, where, and what would be right.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Throws Failure(bad_input).
[[noreturn]] inline void refuse(const std::string& message) {
  throw Failure(ExitCode::bad_input, message);
}

}  // namespace pupflow::io
