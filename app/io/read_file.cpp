#include "app/io/read_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "app/io/failure.h"

namespace pupflow::io {
namespace {

Failure unreadable(const std::string& path, int error) {
  return {ExitCode::bad_file, path + ": cannot read: " + std::generic_category().message(error)};
}

/// Reads at most `count` bytes; closes the descriptor. Returns the error number, 0 when fine.
int read_some(int descriptor, std::size_t count, std::string& bytes) {
  while (bytes.size() < count) {
    char buffer[1 << 16];
    const ssize_t got = ::read(descriptor, buffer, std::min(sizeof buffer, count - bytes.size()));
    if (got == 0) break;
    if (got > 0) {
      bytes.append(buffer, static_cast<std::size_t>(got));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

std::string read_beginning(const std::string& path, std::size_t count) {
  const bool standard_input = path == "-";
  const int descriptor =
      standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) throw unreadable(path, errno);
  std::string bytes;
  const int error = read_some(descriptor, count, bytes);
  if (!standard_input) ::close(descriptor);
  if (error != 0) throw unreadable(path, error);
  return bytes;
}

std::string read_file(const std::string& path, std::size_t limit) {
  std::string bytes = read_beginning(path, limit + 1);
  if (bytes.size() <= limit) return bytes;
  throw Failure(ExitCode::bad_file, path + ": larger than the " + std::to_string(limit) +
                                        " bytes such a file may have");
}

}  // namespace pupflow::io
