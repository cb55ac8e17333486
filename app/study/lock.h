// One process at a time works in the folder of a sweep.
#pragma once

#include <string>

namespace pupflow::study {

/// Holds the folder of a sweep for this process. The system lets go when the process ends, however
/// it ends; the file that it locks, sweep.lock, may then stay and does no harm.
class FolderLock {
 public:
  /// Makes the folder if there is none. Throws io::Failure(bad_file) when another process holds it, or
  /// it cannot be made or written to. Where the file system has no locks, says so on standard error.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  /// Whether the open file is locked and still has its name.
  bool take(const std::string& folder) const;
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace pupflow::study
