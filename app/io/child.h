// A program that this one starts and waits for, without a shell.
#pragma once

#include <string>
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

}  // namespace pupflow::io
