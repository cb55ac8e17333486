#include "app/io/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <sstream>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/read_file.h"

extern char** environ;

namespace pupflow::io {
namespace {

namespace fs = std::filesystem;

constexpr int kNotInstalled = 127;  // a shell's exit status for a command that is not found

/// Names of the files that gnuplot writes into the drawing's folder. They are removed at the end.
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
  // A shell changes the folder. Names are arguments of it, never part of its program text.
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

/// The last line of what gnuplot wrote on standard error.
std::string complaint(const Temporary& temporary) {
  std::string text;
  try {
    text = read_file(temporary.base + ".log", std::size_t{1} << 20);
  } catch (const Failure&) {
    return "it left no message";
  }
  while (text.ends_with('\n')) text.pop_back();
  return text.empty() ? "it left no message" : text.substr(text.rfind('\n') + 1);
}

/// Writes both pictures to their final names, with the text that tells how to make them again.
void publish(const Temporary& temporary, const Drawing& drawing) {
  const std::string target = drawing.folder + "/" + drawing.name;
  write_png(target + ".png", read_png(temporary.base + ".png"), drawing.text, true);
  std::string svg = read_file(temporary.base + ".svg", std::size_t{1} << 30);
  const std::size_t root = svg.find("<svg");
  if (root == std::string::npos || svg.find("</svg>") == std::string::npos) {
    throw Failure(ExitCode::bad_file,
                  target + ".svg: gnuplot wrote no whole picture; is the disk full?");
  }
  svg.insert(root, "<!--\n" + drawing.note + "-->\n");
  AtomicFile file(target + ".svg", true);
  file.write(svg);
  file.commit();
}

}  // namespace

std::string gnuplot_script(const std::string& name, const std::string& source, int width,
                           int height, const std::string& body, const std::string& data) {
  std::ostringstream s;
  s << "# Draws " << name << ".png and " << name << ".svg from " << source << ".\n"
    << "# Run it again after editing:  gnuplot " << name << ".gp  (in this folder)\n"
    << "if (!exists('name')) name = '" << name << "'\n"
    << "set datafile separator ','\nset datafile commentschars '#'\nset datafile columnheaders\n"
    << "set encoding utf8\nset border 3 lc '#444444'\nset tics nomirror out textcolor '#222222'\n"
    << data << "do for [format in 'png svg'] {\n"
    << "  if (format eq 'png') {\n    set terminal pngcairo size " << width << ',' << height
    << " font 'DejaVu Sans,11'\n  } else {\n    set terminal svg size " << width << ',' << height
    << " font 'DejaVu Sans,11' background '#ffffff'\n  }\n"
    << "  set output name.'.'.format\n"
    << body << "  unset output\n}\n";
  return s.str();
}

Drawn draw(const Drawing& drawing) {
  const std::string script = drawing.name + ".gp";
  const Temporary temporary(drawing.folder);
  const int status = run_gnuplot(drawing.folder, script, temporary);
  if (interrupted()) return Drawn::interrupted;
  if (status == kNotInstalled) return Drawn::no_gnuplot;
  if (status != 0) {
    throw Failure(ExitCode::bad_file, drawing.folder + "/" + script +
                                          ": gnuplot failed with exit code " +
                                          std::to_string(status) + " (" + complaint(temporary) +
                                          "); the CSV files are complete");
  }
  publish(temporary, drawing);
  return Drawn::done;
}

std::string no_gnuplot_text(const Drawing& drawing) {
  return "no plot: gnuplot is not installed; install it (Debian: gnuplot-nox) and run this command "
         "again, or 'gnuplot " +
         drawing.name + ".gp' in " + drawing.folder;
}

const char* const kViridisPalette =
    "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 "
    "'#28ae80', 6 '#5ec962', 7 '#addc30', 8 '#fde725')\n";

}  // namespace pupflow::io
