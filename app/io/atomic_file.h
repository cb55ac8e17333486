// Output files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace pupflow::io {

/// Whether `path` names a place that is written to directly and never replaced: "-" and
/// /dev/stdout (standard output), /dev/stderr, /dev/fd/N, and every device, pipe or socket.
bool is_stream(const std::string& path);

/// Whether `path` is standard output ("-" or /dev/stdout).
bool is_standard_output(const std::string& path);

/// Call it for every output before long work starts. Throws Failure(bad_file) when a file could
/// not be put at `path`: something is there and `force` is false, it is a folder or a link to
/// nothing, its name is too long, or its folder does not exist or cannot be written to.
void refuse_existing(const std::string& path, bool force);

/// Throws Failure(bad_file) when `path` is a stream, for kinds of files that cannot go to one.
void refuse_stream(const std::string& path);

/// The end of a temporary file's name, NAME.PROCESS.unfinished. While it is written it has a shared
/// lock (flock); one without was left by a process that was killed.
inline constexpr std::string_view kUnfinished = ".unfinished";

/// Text to standard output, at once, without control characters but \n and \t. Throws
/// Failure(bad_file) when not all of it got there (closed pipe, full disk).
void print(std::string_view text);

/// A file being written. Bytes go to a temporary file in the folder of `path`, which takes its
/// place (and keeps the permissions of what it replaces) in `commit`; without that it is removed
/// again. A stream (see is_stream) gets the bytes directly. All members throw Failure(bad_file)
/// that names the path and the reason; every write is checked.
class AtomicFile {
 public:
  /// As `refuse_existing`, then opens the temporary file.
  AtomicFile(const std::string& path, bool force);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);

  /// The temporary file, for libraries that open files by name; then nothing goes through `write`.
  /// Throws for a stream, which has none.
  const std::string& written_aside() const;

  /// Replaces the first bytes of the temporary file. What goes through `write` is not looked at.
  void write_at_start(std::string_view bytes);

  /// Leaves the temporary file where it is, for whoever wants what is in it. Last, in place of
  /// `commit`.
  void keep();

  /// Writes out what is buffered, flushes it to the disk and puts the file in its place. Once,
  /// last.
  void commit();

 private:
  void open_temporary();
  void drain();
  void put_in_place();
  [[noreturn]] void fail(int error) const;

  std::string path_;       // as the user named it
  std::string target_;     // where it goes: links followed
  std::string temporary_;  // empty for a stream
  std::string buffer_;
  int descriptor_ = -1;
  bool force_;
};

}  // namespace pupflow::io
