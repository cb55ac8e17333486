// A child process whose standard output is read line by line.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace pupflow::testing {

using Environment = std::vector<std::string>;  // NAME=value

/// Where children keep their settings instead of the user's XDG_CONFIG_HOME: what one of them keeps,
/// the next one of this process finds.
std::string config_folder();

struct ChildOptions {
  std::vector<std::string> arguments;  // the program first, found on PATH
  Environment environment;             // added to this process' own; "NAME" alone takes it away
  std::string folder;                  // to run in; empty: this one
};

class Child {
 public:
  static constexpr std::chrono::seconds kPatience{60};

  /// Starts it. Throws std::runtime_error when it cannot be started.
  explicit Child(const ChildOptions& options);

  /// Kills it when it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The next line of its standard output; nothing at its end or when none comes for that long.
  std::optional<std::string> read_line(std::chrono::milliseconds patience = kPatience);

  /// The process, for /proc; -1 once its end was waited for.
  pid_t pid() const { return pid_; }

  void send_signal(int signal) const;

  /// Waits for its end. Its exit code, or 128 + the signal that ended it; nothing when it goes on
  /// for longer than kPatience.
  std::optional<int> wait();

  /// What it wrote to standard error; once it has ended.
  std::string errors() const;

 private:
  pid_t pid_ = -1;
  int output_ = -1, error_file_ = -1;
  std::string buffer_;
};

/// Runs a command to its end and returns its exit code; -1 when it could not be run or went on for
/// too long.
int run_command(const ChildOptions& options);

}  // namespace pupflow::testing
