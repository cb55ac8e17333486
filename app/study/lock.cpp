#include "app/study/lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "app/io/failure.h"
#include "app/io/note.h"
#include "app/study/files.h"

namespace pupflow::study {

FolderLock::FolderLock(const std::string& folder) : path_(lock_path(folder)) {
  make_folder(folder);
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    refuse_no_file(path_);
    descriptor_ =
        ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw io::Failure(io::ExitCode::bad_file,
                        path_ + ": cannot write: " + std::generic_category().message(errno));
    }
  } while (!take(folder));
}

bool FolderLock::take(const std::string& folder) const {
  while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw io::Failure(io::ExitCode::bad_file,
                        folder +
                            ": another process computes a sweep there; wait until it ends, or "
                            "name another folder with --out");
    }
    io::note(folder + ": this file system has no locks; start no second process there");
    return true;
  }
  // The process that held it before may have removed the file meanwhile.
  struct stat locked = {}, named = {};
  return ::fstat(descriptor_, &locked) == 0 && ::lstat(path_.c_str(), &named) == 0 &&
         locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace pupflow::study
