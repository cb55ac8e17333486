#include "app/io/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
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

/// `input` becomes its standard input; -1: it reads nothing.
pid_t start(const Child& child, const Pipe& pipe, int input) {
  std::vector<std::string> words{child.program}, variables = child.environment;
  words.insert(words.end(), child.arguments.begin(), child.arguments.end());
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, child.folder.c_str());
  if (input < 0) {
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  } else {
    ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  }
  ::posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], STDERR_FILENO);
  pid_t process = 0;
  const int error = ::posix_spawn(&process, child.program.c_str(), &actions, nullptr,
                                  pointers(words).data(), pointers(variables).data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(child.program, error);
  return process;
}

/// Waits for the end of a process that prints into `pipe`; kills it after Ctrl-C. `end` may hold
/// what it printed before.
void wait_for(pid_t process, const Pipe& pipe, ChildEnd& end) {
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
}

/// Two joined sockets: unlike a pipe, one whose reader is gone can be written to without a signal.
struct Sockets {
  std::array<int, 2> ends{-1, -1};

  explicit Sockets(const std::string& program) {
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      fail(program, errno);
    }
  }
  ~Sockets() {
    for (const int end : {0, 1}) close(end);
  }
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;

  void close(int end) {
    int& descriptor = ends[static_cast<std::size_t>(end)];
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
  }
};

}  // namespace

ChildEnd run_child(const Child& child) {
  Pipe pipe(child.program);
  const pid_t process = start(child, pipe, -1);
  pipe.close_writing();
  ChildEnd end;
  wait_for(process, pipe, end);
  return end;
}

struct FedChild::Process {
  explicit Process(const Child& child)
      : pipe(child.program), input(child.program), id(start(child, pipe, input.ends[1])) {
    pipe.close_writing();
    input.close(1);
  }

  Pipe pipe;
  Sockets input;
  pid_t id;
  bool ended = false;
  ChildEnd end;
};

FedChild::FedChild(const Child& child) : process_(std::make_unique<Process>(child)) {}

FedChild::~FedChild() {
  if (process_->ended) return;
  ::kill(process_->id, SIGKILL);
  while (::waitpid(process_->id, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool FedChild::feed(std::string_view bytes) {
  const int input = process_->input.ends[0];
  while (!bytes.empty()) {
    std::array<pollfd, 2> waited{{{input, POLLOUT, 0}, {process_->pipe.ends[0], POLLIN, 0}}};
    ::poll(waited.data(), waited.size(), 100);
    if (interrupted()) {
      ::kill(process_->id, SIGKILL);
      return false;
    }
    process_->pipe.read_into(process_->end.last_words);
    const ssize_t sent = ::send(input, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (errno != EINTR && errno != EAGAIN) {
      return false;
    }
  }
  return true;
}

ChildEnd FedChild::finish() {
  process_->input.close(0);
  wait_for(process_->id, process_->pipe, process_->end);
  process_->ended = true;
  return process_->end;
}

}  // namespace pupflow::io
