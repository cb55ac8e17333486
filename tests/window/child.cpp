#include "tests/window/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "tests/support/scratch.h"

extern char** environ;

namespace pupflow::testing {
namespace {

using Clock = std::chrono::steady_clock;

std::string name_of(const std::string& setting) {
  return setting.substr(0, setting.find('='));
}

std::vector<std::string> merged(Environment changes) {
  const bool chosen = std::any_of(changes.begin(), changes.end(), [](const std::string& change) {
    return name_of(change) == "XDG_CONFIG_HOME";
  });
  if (!chosen) changes.push_back("XDG_CONFIG_HOME=" + config_folder());
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const bool changed =
        std::any_of(changes.begin(), changes.end(),
                    [&](const std::string& change) { return name_of(change) == name_of(*entry); });
    if (!changed) all.emplace_back(*entry);
  }
  for (const std::string& change : changes) {
    if (change.find('=') != std::string::npos) all.push_back(change);
  }
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> list;
  for (std::string& text : strings) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

}  // namespace

std::string config_folder() {
  static const test::Scratch scratch;
  return scratch.folder().string();
}

Child::Child(const ChildOptions& options) {
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  error_file_ = memfd_create("errors", MFD_CLOEXEC);
  if (error_file_ < 0)
    throw std::runtime_error("no file for what the child says on standard error");

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error_file_, STDERR_FILENO);
  if (!options.folder.empty()) {
    posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  }
  std::vector<std::string> arguments = options.arguments;
  std::vector<std::string> environment = merged(options.environment);
  const int failed = posix_spawnp(&pid_, arguments[0].c_str(), &actions, nullptr,
                                  pointers(arguments).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  close(pipe[1]);
  output_ = pipe[0];
  if (failed != 0) {
    pid_ = -1;
    throw std::runtime_error(arguments[0] + " cannot be run: " + std::strerror(failed));
  }
}

Child::~Child() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(output_);
  close(error_file_);
}

std::optional<std::string> Child::read_line(std::chrono::milliseconds patience) {
  const auto give_up = Clock::now() + patience;
  while (true) {
    const std::size_t end = buffer_.find('\n');
    if (end != std::string::npos) {
      std::string line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return line;
    }
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(give_up - Clock::now()).count();
    pollfd waiting{output_, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(std::max<long>(left, 0))) <= 0) return {};
    std::array<char, 4096> bytes;
    const ssize_t count = read(output_, bytes.data(), bytes.size());
    if (count <= 0) return {};
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

void Child::send_signal(int signal) const {
  kill(pid_, signal);
}

std::optional<int> Child::wait() {
  const auto give_up = Clock::now() + kPatience;
  int status = 0;
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (Clock::now() > give_up) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string Child::errors() const {
  std::string text;
  std::array<char, 4096> bytes;
  off_t place = 0;
  ssize_t count = 0;
  while ((count = pread(error_file_, bytes.data(), bytes.size(), place)) > 0) {
    text.append(bytes.data(), static_cast<std::size_t>(count));
    place += count;
  }
  return text;
}

int run_command(const ChildOptions& options) {
  return Child(options).wait().value_or(-1);
}

}  // namespace pupflow::testing
