#include "app/io/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::io {
namespace {

constexpr std::size_t kKept = std::size_t{1} << 16;  // bytes of the last words

[[noreturn]] void fail(const std::string& program, int error) {
  throw Failure(ExitCode::bad_file,
                program + ": cannot start: " + std::generic_category().message(error));
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

/// A pipe from the child. Its reading end never blocks.
struct Pipe {
  std::array<int, 2> ends{-1, -1};

  explicit Pipe(const std::string& program) {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(program, errno);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    ::close(ends[0]);
    close_writing();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_writing() {
    if (ends[1] >= 0) ::close(ends[1]);
    ends[1] = -1;
  }

  /// Reads what is there; false at the end.
  bool read_into(std::string& text) const {
    std::array<char, 4096> buffer;
    ssize_t got = 0;
    while ((got = ::read(ends[0], buffer.data(), buffer.size())) > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(got));
      if (text.size() > kKept) text.erase(0, text.size() - kKept);
    }
    return got < 0;
  }
};

pid_t start(const Child& child, const Pipe& pipe) {
  std::vector<std::string> words{child.program}, variables = child.environment;
  words.insert(words.end(), child.arguments.begin(), child.arguments.end());
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, child.folder.c_str());
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], STDERR_FILENO);
  pid_t process = 0;
  const int error = ::posix_spawn(&process, child.program.c_str(), &actions, nullptr,
                                  pointers(words).data(), pointers(variables).data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(child.program, error);
  return process;
}

}  // namespace

ChildEnd run_child(const Child& child) {
  Pipe pipe(child.program);
  const pid_t process = start(child, pipe);
  pipe.close_writing();
  ChildEnd end;
  pollfd reading{pipe.ends[0], POLLIN, 0};
  int status = 0;
  for (bool ended = false; !ended;) {
    ::poll(&reading, 1, reading.fd >= 0 ? 100 : 1);  // a signal ends it, too
    if (reading.fd >= 0 && !pipe.read_into(end.last_words)) reading.fd = -1;
    if (interrupted()) ::kill(process, SIGKILL);
    ended = ::waitpid(process, &status, WNOHANG) != 0;
  }
  pipe.read_into(end.last_words);
  end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return end;
}

}  // namespace pupflow::io
