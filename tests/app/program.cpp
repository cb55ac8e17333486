#include "program.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace pupflow::test {
namespace {

std::string all_of(int descriptor) {
  std::string text;
  char buffer[4096];
  ::lseek(descriptor, 0, SEEK_SET);
  for (ssize_t got; (got = ::read(descriptor, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(got));
  }
  ::close(descriptor);
  return text;
}

}  // namespace

Running::Running(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& folder)
    : out_(::memfd_create("out", 0)), err_(::memfd_create("err", 0)), process_(-1) {
  std::vector<std::string> words{program};  // execv asks for text that it might write to
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  process_ = ::fork();  // NOLINT(cppcoreguidelines-prefer-member-initializer): argv comes first
  if (process_ < 0 || out_ < 0 || err_ < 0) throw std::runtime_error("cannot start " + program);
  if (process_ == 0) {
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    ::dup2(out_, STDOUT_FILENO);
    ::dup2(err_, STDERR_FILENO);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
}

Running::~Running() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Running::signal(int number) const {
  ::kill(process_, number);
}

Outcome Running::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = 0;
  Outcome outcome;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = all_of(out_);
  outcome.err = all_of(err_);
  return outcome;
}

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::string& folder) {
  return Running(program, arguments, folder).wait();
}

}  // namespace pupflow::test
