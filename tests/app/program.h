// Runs the real executable.
#pragma once

#include <string>
#include <vector>

namespace pupflow::test {

/// What came of one run.
struct Outcome {
  int code = -1;  // exit code; 128 + the signal's number when one ended it
  std::string out, err;
};

/// Runs `program` with `arguments` in `folder` and waits for it.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::string& folder);

/// A program that goes on in the background.
class Running {
 public:
  Running(const std::string& program, const std::vector<std::string>& arguments,
          const std::string& folder);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void signal(int number) const;

  /// Waits for the end. Once.
  Outcome wait();

 private:
  int out_, err_;  // unnamed files that take what it prints
  int process_;
};

}  // namespace pupflow::test
