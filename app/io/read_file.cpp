#include "app/io/read_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "app/io/failure.h"
#include "app/io/interrupt.h"

namespace pupflow::io {
namespace {

Failure unreadable(const std::string& path, int error) {
  return {ExitCode::bad_file, path + ": cannot read: " + std::generic_category().message(error)};
}

/// A file open for reading; "-" is standard input, which stays open.
class Input {
 public:
  explicit Input(const std::string& path) : path_(path) {
    if (path == "-") return;
    // O_NONBLOCK: else opening a pipe waits for its writer, deaf to Ctrl-C.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    if (descriptor_ < 0) throw unreadable(path, errno);
  }
  ~Input() {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  bool is_regular() const {
    struct stat status = {};
    return ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  }

  bool is_folder() const {
    struct stat status = {};
    return ::fstat(descriptor_, &status) == 0 && S_ISDIR(status.st_mode);
  }

  /// At most `count` bytes: fewer only where the file ends.
  std::string read(std::size_t count) const {
    std::string bytes;
    while (bytes.size() < count) {
      if (!wait_until_ready(descriptor_, POLLIN)) {
        throw Failure(ExitCode::interrupted, "interrupted while reading " + path_);
      }
      char buffer[1 << 16];
      const ssize_t got =
          ::read(descriptor_, buffer, std::min(sizeof buffer, count - bytes.size()));
      if (got == 0) break;
      if (got > 0) {
        bytes.append(buffer, static_cast<std::size_t>(got));
      } else if (errno != EINTR && errno != EAGAIN) {
        throw unreadable(path_, errno);
      }
    }
    return bytes;
  }

 private:
  const std::string& path_;
  int descriptor_ = STDIN_FILENO;
};

}  // namespace

std::string read_beginning(const std::string& path, std::size_t count) {
  const Input input(path);
  if (!input.is_regular() && !input.is_folder()) {
    throw Failure(ExitCode::bad_file, path +
                                          ": is a pipe or a device, and this kind of file is read "
                                          "twice; save it to a file first");
  }
  return input.read(count);
}

std::string read_file(const std::string& path, std::size_t limit) {
  std::string bytes = Input(path).read(limit + 1);
  if (bytes.size() <= limit) return bytes;
  throw Failure(ExitCode::bad_file, path + ": larger than the " + std::to_string(limit) +
                                        " bytes such a file may have");
}

}  // namespace pupflow::io
