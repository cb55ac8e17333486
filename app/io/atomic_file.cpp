#include "app/io/atomic_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuffer = 1 << 16;

/// Bytes that the name of the temporary file may have more than that of its target.
constexpr std::size_t kLongestEnding = 32;

Failure unwritable(const std::string& path, int error) {
  const std::string name = is_standard_output(path) ? "standard output" : path;
  if (error == ECANCELED) return {ExitCode::interrupted, name + ": interrupted while writing"};
  return {ExitCode::bad_file, name + ": cannot write: " + std::generic_category().message(error)};
}

/// The descriptor that a path such as /dev/fd/3 stands for, or -1. Opening such a path would
/// truncate or refuse a redirected file, so these are duplicated instead.
int named_descriptor(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(prefix)) continue;
    const auto number = read_number<int>(std::string_view(path).substr(prefix.size()));
    if (number) return *number;
  }
  return -1;
}

/// What a pipe that is ready takes without waiting.
constexpr std::size_t kPipePiece = PIPE_BUF;

/// Writes everything, to a pipe or device in pieces; returns 0 or the error number: ECANCELED where
/// nobody takes the bytes, and Ctrl-C came.
int write_all(int descriptor, std::string_view bytes, bool to_stream) {
  while (!bytes.empty()) {
    if (!wait_until_ready(descriptor, POLLOUT)) return ECANCELED;
    const ssize_t written = ::write(descriptor, bytes.data(),
                                    to_stream ? std::min(bytes.size(), kPipePiece) : bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR && errno != EAGAIN) {
      return errno;
    }
  }
  return 0;
}

/// Opens a device, or a pipe as soon as it has a reader; -1 with errno where that fails, ECANCELED
/// after Ctrl-C.
int open_stream(const std::string& path) {
  for (;;) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    if (descriptor >= 0 || (errno != ENXIO && errno != EINTR)) return descriptor;
    if (interrupted()) {
      errno = ECANCELED;
      return -1;
    }
    ::poll(nullptr, 0, 50);
  }
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void refuse_long_name(const std::string& path) {
  const std::size_t most = NAME_MAX - kLongestEnding;
  if (fs::path(path).filename().string().size() <= most) return;
  throw Failure(ExitCode::bad_file, path + ": this name is too long; a file's may have " +
                                        std::to_string(most) + " bytes");
}

}  // namespace

bool is_standard_output(const std::string& path) {
  return named_descriptor(path) == STDOUT_FILENO;
}

bool is_stream(const std::string& path) {
  if (named_descriptor(path) >= 0) return true;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void refuse_existing(const std::string& path, bool force) {
  if (path.empty()) throw Failure(ExitCode::bad_file, "the name of an output file is empty");
  if (is_stream(path)) return;
  refuse_long_name(path);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    throw Failure(ExitCode::bad_file, path + ": is a folder; name a file in it");
  }
  if (fs::exists(status)) {
    if (force) return;
    throw Failure(ExitCode::bad_file, path + ": exists already; use --force to replace it");
  }
  if (status.type() == fs::file_type::none) throw unwritable(path, error.value());
  if (fs::is_symlink(fs::symlink_status(path, error))) {
    throw Failure(ExitCode::bad_file,
                  path + ": is a link to a file that is not there; remove it or name another file");
  }
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, error)) {
    throw Failure(ExitCode::bad_file, path + ": cannot write: there is no folder " +
                                          folder.string() + "; create it first");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) throw unwritable(path, errno);
}

void refuse_stream(const std::string& path) {
  if (!is_stream(path)) return;
  throw Failure(ExitCode::bad_file,
                path + ": this kind of file cannot go to a pipe or device; name a file");
}

void print(std::string_view text) {
  const std::string shown = printable(text, "\n\t");
  if (const int error = write_all(STDOUT_FILENO, shown, true)) throw unwritable("-", error);
}

AtomicFile::AtomicFile(const std::string& path, bool force) : path_(path), force_(force) {
  refuse_existing(path, force);
  if (!is_stream(path)) {
    open_temporary();
    return;
  }
  const int named = named_descriptor(path);
  descriptor_ = named >= 0 ? ::fcntl(named, F_DUPFD_CLOEXEC, 0) : open_stream(path);
  if (descriptor_ < 0) fail(errno);
}

void AtomicFile::open_temporary() {
  std::error_code error;
  target_ = path_;
  if (fs::is_symlink(path_, error)) {
    target_ = fs::canonical(path_, error).string();
    if (error) fail(error.value());
  }
  struct stat old = {};
  const bool replaces = ::stat(target_.c_str(), &old) == 0;
  const fs::path folder = folder_of(target_);
  const std::string name = fs::path(target_).filename().string();
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    const std::string number = attempt == 0 ? "" : "-" + std::to_string(attempt);
    const std::string process = std::to_string(::getpid()) + number;
    temporary_ = (folder / (name + "." + process + std::string(kUnfinished))).string();
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) {
      const int reason = errno;
      temporary_.clear();
      fail(reason);
    }
  }
  ::flock(descriptor_, LOCK_SH);  // tells other processes that this one lives
  if (replaces && ::fchmod(descriptor_, old.st_mode & 07777) != 0) {
    const int reason = errno;
    ::unlink(temporary_.c_str());
    ::close(descriptor_);
    fail(reason);
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(int error) const {
  throw unwritable(path_, error);
}

void AtomicFile::keep() {
  temporary_.clear();
}

void AtomicFile::write_at_start(std::string_view bytes) {
  const auto size = static_cast<ssize_t>(bytes.size());
  errno = 0;
  if (::pwrite(descriptor_, bytes.data(), bytes.size(), 0) != size) {
    fail(errno == 0 ? ENOSPC : errno);
  }
}

void AtomicFile::write(std::string_view bytes) {
  if (bytes.size() < kBuffer) buffer_ += bytes;
  if (buffer_.size() >= kBuffer || bytes.size() >= kBuffer) drain();
  if (bytes.size() < kBuffer) return;
  if (const int error = write_all(descriptor_, bytes, temporary_.empty())) fail(error);
}

const std::string& AtomicFile::written_aside() const {
  if (temporary_.empty()) refuse_stream(path_);
  return temporary_;
}

void AtomicFile::drain() {
  if (const int error = write_all(descriptor_, buffer_, temporary_.empty())) fail(error);
  buffer_.clear();
}

void AtomicFile::commit() {
  drain();
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(errno);
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail(errno);
  if (!temporary_.empty()) put_in_place();
}

void AtomicFile::put_in_place() {
  // Without --force a file that appeared meanwhile must survive; where the file system cannot
  // rename without replacing, a look just before is the best there is.
  if (!force_) {
    if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) ==
        0) {
      temporary_.clear();
      return;
    }
    if (errno != EINVAL && errno != ENOSYS) fail(errno);
    refuse_existing(path_, false);
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

}  // namespace pupflow::io
