#include "app/study/plot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/study/plot_script.h"

extern char** environ;

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

constexpr int kNotInstalled = 127;  // as a shell says it

/// Names for what gnuplot writes, in the sweep's folder; the files are removed at the end.
struct Temporary {
  std::string name = ".pupflow-" + std::to_string(::getpid()), base;

  explicit Temporary(const std::string& folder) : base(folder + "/" + name) {}
  ~Temporary() {
    std::error_code ignored;
    for (const char* ending : {".png", ".svg", ".log"}) fs::remove(base + ending, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
};

/// Runs gnuplot on `script` inside `folder` and returns its exit status.
int run_gnuplot(const std::string& folder, const std::string& script, const Temporary& temporary) {
  // A shell changes the folder; names go to it as arguments, never as program text.
  std::string words[] = {
      "sh",          "-c",   "cd -- \"$1\" && exec gnuplot -e \"name='$3'\" \"$2\" 2>\"$3.log\"",
      "sh",          folder, script,
      temporary.name};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (::posix_spawnp(&child, "sh", nullptr, nullptr, argv.data(), environ) != 0)
    return kNotInstalled;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// What gnuplot complained about: the line that says it.
std::string complaint(const Temporary& temporary) {
  std::string text;
  try {
    text = io::read_file(temporary.base + ".log", std::size_t{1} << 20);
  } catch (const io::Failure&) {
    return "it left no message";
  }
  while (text.ends_with('\n')) text.pop_back();
  return text.empty() ? "it left no message" : text.substr(text.rfind('\n') + 1);
}

/// Puts both pictures in their places, with what is needed to make them again.
void publish(const Temporary& temporary, const std::string& target, const Design& design) {
  const std::string manifest = manifest_text(design);
  const io::Image image = io::read_png(temporary.base + ".png");
  io::write_png(target + ".png", image, io::provenance(design.base, {{"manifest", manifest}}),
                true);
  std::string svg = io::read_file(temporary.base + ".svg", std::size_t{1} << 30);
  const std::size_t root = svg.find("<svg");
  if (root == std::string::npos || svg.find("</svg>") == std::string::npos) {
    throw io::Failure(io::ExitCode::bad_file,
                      target + ".svg: gnuplot wrote no whole picture; is the disk full?");
  }
  svg.insert(root, "<!--\n" + manifest + "-->\n");
  io::AtomicFile file(target + ".svg", true);
  file.write(svg);
  file.commit();
}

}  // namespace

std::vector<std::string> plot_paths(const std::string& folder, const Design& design) {
  const std::string base = folder + "/" + design.name;
  return {base + ".png", base + ".svg", base + ".gp"};
}

std::string draw_plots(const std::string& folder, const Design& design,
                       const std::vector<Summary>& summaries) {
  const std::string text = plot_script(design);
  if (text.empty()) {
    return "no plot: " + std::to_string(plotted_axes(design).size()) +
           " parameters take several values; one gives four panels, two give maps";
  }
  if (std::none_of(summaries.begin(), summaries.end(), [](const Summary& s) { return s.runs > 0; }))
    return "no plot: no run was fine";
  const std::string name = design.name + ".gp", path = folder + "/" + name;
  if (!fs::exists(path)) {
    io::AtomicFile file(path, false);
    file.write(text);
    file.commit();
  }
  const Temporary temporary(folder);
  const int status = run_gnuplot(folder, name, temporary);
  if (io::interrupted()) {
    throw io::Failure(io::ExitCode::interrupted,
                      "interrupted while drawing; the CSV files are complete, and the same command "
                      "draws the figure");
  }
  if (status == kNotInstalled) {
    return "no plot: gnuplot is not installed; install it (Debian: gnuplot-nox) and run this "
           "command again, or 'gnuplot " +
           name + "' in " + folder;
  }
  if (status != 0) {
    throw io::Failure(io::ExitCode::bad_file,
                      path + ": gnuplot failed with exit code " + std::to_string(status) + " (" +
                          complaint(temporary) + "); the CSV files are complete");
  }
  publish(temporary, folder + "/" + design.name, design);
  return {};
}

}  // namespace pupflow::study
