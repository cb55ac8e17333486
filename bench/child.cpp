#include "bench/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <stdexcept>

namespace pupflow::bench {
namespace {

pid_t fork_child() {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process could be started");
  return child;
}

/// Waits for `child` and says what it used.
rusage wait_for(pid_t child, const std::string& name) {
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error(name + " failed");
  }
  return usage;
}

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  execv(program.c_str(), words.data());
  _exit(127);
}

}  // namespace

double run_time(const std::string& program, const std::vector<std::string>& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = fork_child();
  if (child == 0) become(program, arguments);
  wait_for(child, program);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

double peak_memory(void (*work)(int), int argument) {
  const pid_t child = fork_child();
  if (child == 0) {
    try {
      work(argument);
    } catch (const std::exception&) {
      _exit(1);
    }
    _exit(0);
  }
  return 1024.0 * static_cast<double>(wait_for(child, "a litter in a child").ru_maxrss);
}

}  // namespace pupflow::bench
