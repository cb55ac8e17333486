// A program that this one starts and waits for, without a shell.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pupflow::io {

struct Child {
  std::string program;                   // its path; from program_path, say
  std::vector<std::string> arguments;    // without the program's name
  std::string folder;                    // its working folder
  std::vector<std::string> environment;  // "NAME=value"
};

struct ChildEnd {
  int status = 0;          // exit status; 128 + the signal's number when one ended it
  std::string last_words;  // the end of what it printed, on standard output and error
};

/// Runs it to its end. It reads nothing on standard input, and gets no open file of this program.
/// When this program is interrupted the child is killed. Throws Failure(bad_file) that names the
/// program when it cannot be started.
ChildEnd run_child(const Child& child);

/// The same for a program that reads what it is given on standard input while it runs.
class FedChild {
 public:
  /// Starts it. Throws like run_child.
  explicit FedChild(const Child& child);
  /// Kills it where it still runs.
  ~FedChild();
  FedChild(const FedChild&) = delete;
  FedChild& operator=(const FedChild&) = delete;

  /// Returns once it took all bytes. False where it ended before that, or was killed since this
  /// program was interrupted.
  bool feed(std::string_view bytes);

  /// Closes its input and waits for its end. Once, last.
  ChildEnd finish();

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace pupflow::io
