#include "app/io/movie.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/machine.h"
#include "app/io/text.h"

extern char** environ;

namespace pupflow::io {
namespace {

/// How ffmpeg makes a film of one kind.
struct Form {
  std::string_view ending;
  int most_fps;
  std::string_view arguments;  // separated by blanks, behind the input
  bool keeps_comment;          // as metadata; otherwise it is written here
};

// Players take BT.709 for granted where a film is large and not where it is small, so it is named.
// A GIF has a palette a frame: one for all would keep all frames in memory until the last.
#define PUPFLOW_VIDEO                                                                        \
  "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,scale=out_color_matrix=bt709:out_range=tv," \
  "format=yuv420p -colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv "
constexpr Form kForms[] = {
    {".mp4", kMostFps,
     PUPFLOW_VIDEO "-c:v libx264 -preset veryfast -crf 18 -movflags +faststart -f mp4", true},
    {".webm", kMostFps,
     PUPFLOW_VIDEO "-c:v libvpx-vp9 -crf 28 -b:v 0 -deadline good -cpu-used 4 -row-mt 1 -f webm",
     true},
    {".gif", 50,
     "-filter_complex split[a][b];[a]palettegen=stats_mode=single[p];"
     "[b][p]paletteuse=new=1:dither=sierra2_4a -f gif",
     false}};
#undef PUPFLOW_VIDEO

/// The largest frame of level 6.2 of H.264, pixels.
constexpr double kMostPixels = 139264.0 * 256;

/// What the system takes as one argument of a program is 128 KiB.
constexpr std::size_t kLongestComment = 120'000;

const Form& form_of(const std::string& path) {
  const auto fits = [&](const Form& form) { return path.ends_with(form.ending); };
  const auto* form = std::ranges::find_if(kForms, fits);
  if (form == std::end(kForms)) {
    refuse("--movie " + io::quoted(path) + ": its name must end in " + movie_endings());
  }
  return *form;
}

/// This program's environment without what has ffmpeg write reports.
std::vector<std::string> environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with("FFREPORT=")) variables.emplace_back(*variable);
  }
  return variables;
}

Child ffmpeg(const std::string& target, const Form& form, const MovieFile::Options& options,
             const std::string& comment) {
  const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
  Child child{program_path("ffmpeg"), {}, "/", environment()};
  const std::string words =
      "-hide_banner -loglevel error -nostats -y -f rawvideo -pix_fmt rgb0 -video_size " + size +
      " -framerate " + std::to_string(options.fps) + " -i pipe:0 " + std::string(form.arguments);
  for (const std::string_view word : split(words, ' ')) child.arguments.emplace_back(word);
  if (form.keeps_comment) {
    child.arguments.insert(child.arguments.end(), {"-metadata", "comment=" + comment});
  }
  child.arguments.push_back("file:" + target);
  return child;
}

/// Puts a comment in front of the last byte of a GIF, which ends it.
bool add_gif_comment(const std::string& path, std::string_view comment) {
  constexpr char kEnd = ';';
  constexpr std::size_t kLongestBlock = 255;
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(-1, std::ios::end);
  if (file.get() != kEnd) return false;
  file.seekp(-1, std::ios::end);
  file << "\x21\xfe";
  for (; !comment.empty(); comment.remove_prefix(std::min(kLongestBlock, comment.size()))) {
    const std::string_view block = comment.substr(0, kLongestBlock);
    file << static_cast<char>(block.size()) << block;
  }
  file << '\0' << kEnd << std::flush;
  return file.good();
}

/// The last line that ffmpeg printed.
std::string complaint(std::string words) {
  while (words.ends_with('\n')) words.pop_back();
  return words.empty() ? "it left no message" : printable(words.substr(words.rfind('\n') + 1));
}

}  // namespace

std::string movie_endings() {
  std::string endings(kForms[0].ending);
  for (std::size_t i = 1; i < std::size(kForms); ++i) {
    endings += (i + 1 < std::size(kForms) ? ", " : " or ") + std::string(kForms[i].ending);
  }
  return endings;
}

bool names_movie(std::string_view path) {
  return std::ranges::any_of(kForms, [&](const Form& form) { return path.ends_with(form.ending); });
}

void check_movie(const std::string& path, int fps, int width, int height) {
  const Form& form = form_of(path);
  if (fps < 1 || fps > form.most_fps) {
    refuse("--fps " + std::to_string(fps) + ": a film " + std::string(form.ending) + " has 1 to " +
           std::to_string(form.most_fps) + " frames a second");
  }
  if (static_cast<double>(width) * height > kMostPixels) {
    refuse("a film of " + std::to_string(width) + "x" + std::to_string(height) +
           " pixels is too large; a frame may have " + formatted("%.0f", kMostPixels) +
           " pixels, e.g. 8192x4320");
  }
}

bool has_ffmpeg() {
  return !program_path("ffmpeg").empty();
}

std::string no_ffmpeg_text(const std::string& folder) {
  return "no film: ffmpeg is not installed; its frames go to " + folder +
         "; install it (Debian and Ubuntu: apt install ffmpeg) and run this command again";
}

std::string movie_comment(const TextEntries& entries) {
  return joined(entries, "",
                [](const auto& entry) { return "# " + entry.first + " = " + entry.second + "\n"; });
}

MovieFile::MovieFile(const std::string& path, const Options& options)
    : path_(path), comment_(movie_comment(options.text)), file_(path, options.force) {
  check_movie(path, options.fps, options.width, options.height);
  if (comment_.size() > kLongestComment) {
    refuse(path + ": the recipe has " + std::to_string(comment_.size()) +
           " bytes; a film carries at most " + std::to_string(kLongestComment));
  }
  // The working folder is the root: a name must hold from there, too.
  const std::string target = std::filesystem::absolute(file_.written_aside()).string();
  ffmpeg_.emplace(ffmpeg(target, form_of(path), options, comment_));
}

void MovieFile::add(const Image& frame) {
  const std::string_view bytes(reinterpret_cast<const char*>(frame.rgba.data()), frame.rgba.size());
  if (!ffmpeg_->feed(bytes)) fail(ffmpeg_->finish());
}

void MovieFile::finish() {
  const ChildEnd end = ffmpeg_->finish();
  // ffmpeg ends well after some failed writes, but not without words.
  if (end.status != 0 || !end.last_words.empty()) fail(end);
  if (!form_of(path_).keeps_comment && !add_gif_comment(file_.written_aside(), comment_)) {
    throw Failure(ExitCode::bad_file, path_ + ": cannot add the comment; is the disk full?");
  }
  file_.commit();
}

void MovieFile::fail(const ChildEnd& end) const {
  if (interrupted()) {
    throw Failure(ExitCode::interrupted, "interrupted; no film was written");
  }
  const std::string failed = end.status == 0
                                 ? "ffmpeg could not write the film"
                                 : "ffmpeg failed with exit code " + std::to_string(end.status);
  throw Failure(ExitCode::bad_file, path_ + ": " + failed + " (" + complaint(end.last_words) +
                                        "); no film was written");
}

}  // namespace pupflow::io
