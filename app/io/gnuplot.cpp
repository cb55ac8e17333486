#include "app/io/gnuplot.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>

#include "app/io/atomic_file.h"
#include "app/io/celsius.h"
#include "app/io/child.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/machine.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"

extern char** environ;

namespace pupflow::io {
namespace {

namespace fs = std::filesystem;

/// A folder of its own in the drawing's folder, for what gnuplot writes. It is removed at the end.
struct Temporary {
  std::string name, path;  // within the drawing's folder; with it

  explicit Temporary(const std::string& folder) {
    std::error_code error;
    bool made = false;
    for (int attempt = 0; !made && !error; ++attempt) {
      name = ".pupflow-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".plot";
      path = folder + "/" + name;
      made = fs::create_directory(path, error);
    }
    if (error)
      throw Failure(ExitCode::bad_file, path + ": cannot make this folder: " + error.message());
  }
  ~Temporary() {
    std::error_code ignored;
    try {
      fs::remove_all(path, ignored);
    } catch (const std::bad_alloc&) {
      // the folder stays behind
    }
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
};

/// This program's environment without what changes gnuplot's pictures or has it read more files.
/// `home` is a folder that holds nothing.
std::vector<std::string> environment(const std::string& home) {
  std::vector<std::string> variables{"HOME=" + home};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    bool left_out = false;
    for (const std::string_view start : {"HOME=", "XDG_", "GNU", "GDFONTPATH=", "FIT_"})
      left_out = left_out || text.starts_with(start);
    if (!left_out) variables.emplace_back(text);
  }
  return variables;
}

ChildEnd run_gnuplot(const std::string& program, const Drawing& drawing,
                     const Temporary& temporary) {
  const std::string script =
      drawing.script.empty() ? drawing.name + ".gp" : fs::absolute(drawing.script).string();
  return run_child({program,
                    {"-d", "-e", "name='" + temporary.name + "/figure'", script},
                    drawing.folder,
                    environment(fs::absolute(temporary.path).string())});
}

/// The last line of what gnuplot wrote.
std::string complaint(std::string words) {
  while (words.ends_with('\n')) words.pop_back();
  return words.empty() ? "it left no message" : words.substr(words.rfind('\n') + 1);
}

Failure cut_picture(const std::string& path) {
  return Failure(ExitCode::bad_file, path + ": gnuplot wrote no whole picture; is the disk full?");
}

Image read_drawn(const std::string& made, const std::string& target) {
  try {
    return read_png(made);
  } catch (const Failure&) {
    throw cut_picture(target);
  }
}

/// Writes both pictures to their final names, with the text that tells how to make them again.
void publish(const Temporary& temporary, const Drawing& drawing) {
  const std::string target = drawing.folder + "/" + drawing.name, made = temporary.path + "/figure";
  for (const char* ending : {".png", ".svg"}) {
    if (fs::is_regular_file(fs::symlink_status(made + ending))) continue;
    throw Failure(ExitCode::bad_file,
                  target + ending +
                      ": the script drew no such picture; it must set output to "
                      "name.'" +
                      ending + "'");
  }
  write_png(target + ".png", read_drawn(made + ".png", target + ".png"), drawing.text, true);
  std::string svg = read_file(made + ".svg", std::size_t{1} << 30);
  const std::size_t root = svg.find("<svg");
  if (root == std::string::npos || svg.find("</svg>") == std::string::npos) {
    throw cut_picture(target + ".svg");
  }
  svg.insert(root, "<!--\n" + drawing.note + "-->\n");
  AtomicFile file(target + ".svg", true);
  file.write(svg);
  file.commit();
}

}  // namespace

std::string gnuplot_script(const std::string& name, const std::string& source, int width,
                           int height, const std::string& body, const std::string& data) {
  io::TextStream s;
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
  const std::string program = program_path("gnuplot");
  if (program.empty()) return Drawn::no_gnuplot;
  const Temporary temporary(drawing.folder);
  const ChildEnd end = run_gnuplot(program, drawing, temporary);
  if (interrupted()) return Drawn::interrupted;
  if (end.status != 0) {
    const std::string script =
        drawing.script.empty() ? drawing.folder + "/" + drawing.name + ".gp" : drawing.script;
    throw Failure(ExitCode::bad_file,
                  script + ": gnuplot failed with exit code " + std::to_string(end.status) + " (" +
                      complaint(end.last_words) + "); the CSV files are complete");
  }
  publish(temporary, drawing);
  return Drawn::done;
}

std::string no_gnuplot_text(const Drawing& drawing) {
  return "no plot: gnuplot is not installed; install it (Debian: gnuplot-nox) and run this command "
         "again, or 'gnuplot " +
         drawing.name + ".gp' in " + drawing.folder;
}

std::string celsius_axis(const std::string& axis, double low, double high) {
  // Left to itself, gnuplot takes the step from the other axis, as it stands there.
  const double most = std::max(celsius(high - low), 1e-6) / 4;
  const double power = std::pow(10, std::floor(std::log10(most)));
  const double step = most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
  const std::string second = axis + "2";
  return "  set link " + second + " via " + axis + "*37/0.6 inverse " + axis + "*0.6/37\n  set " +
         second + "tics " + number_text(step) +
         " nomirror out format '%g \u00b0C' font ',9' textcolor '#777777'\n";
}

std::string no_celsius_axis(const std::string& axis) {
  const std::string second = axis + "2";
  return "  unset link " + second + "\n  unset " + second + "tics\n  set format " + second +
         "\n  set " + second + "tics autofreq font ''\n  unset " + second + "tics\n";
}

const char* const kViridisPalette =
    "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 "
    "'#28ae80', 6 '#5ec962', 7 '#addc30', 8 '#fde725')\n";

}  // namespace pupflow::io
