// Films, encoded by the system's ffmpeg.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/io/atomic_file.h"
#include "app/io/child.h"
#include "app/io/png.h"

namespace pupflow::io {

constexpr int kMostFps = 120;  // frames a second; a GIF may have 50

/// The endings that films may have, for help and messages: ".mp4, .webm or .gif".
std::string movie_endings();

/// Whether it ends as a film's does.
bool names_movie(std::string_view path);

/// Throws Failure(bad_input) when the name has another ending, or the film cannot have so many
/// frames a second or such a size in pixels.
void check_movie(const std::string& path, int fps, int width, int height);

/// Whether ffmpeg is found in PATH.
bool has_ffmpeg();

/// The message where it is not: what to install, and where its frames go meanwhile.
std::string no_ffmpeg_text(const std::string& folder);

/// What a film carries as its comment: a line "# name = value" for each entry, as CSV files do.
std::string movie_comment(const TextEntries& entries);

/// A film being written. It appears whole in `finish`, or not at all. Odd sides get a white line of
/// pixels, since most players need even ones. Members throw Failure: bad_file when ffmpeg fails,
/// with its last words; interrupted after Ctrl-C.
class MovieFile {
 public:
  struct Options {
    int width = 0, height = 0;  // of every frame, pixels
    int fps = 25;
    TextEntries text;
    bool force = false;  // overwrite
  };

  /// Starts ffmpeg. Also throws bad_input, as check_movie, and when the text is too long.
  MovieFile(const std::string& path, const Options& options);

  /// Returns when ffmpeg has taken the frame.
  void add(const Image& frame);

  /// Once, last.
  void finish();

 private:
  [[noreturn]] void fail(const ChildEnd& end) const;

  std::string path_, comment_;
  AtomicFile file_;
  std::optional<FedChild> ffmpeg_;
};

}  // namespace pupflow::io
