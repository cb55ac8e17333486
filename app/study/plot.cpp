#include "app/study/plot.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/png.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

extern char** environ;

namespace pupflow::study {
namespace {

/// A parameter's symbol in gnuplot's enhanced text, with its unit.
std::string label(const Parameter& parameter) {
  if (parameter.symbol.empty()) return std::string(parameter.title);
  const std::string symbol(parameter.symbol);
  std::string text;
  for (std::size_t i = 0; i < symbol.size(); ++i) {
    if (symbol[i] != '_') {
      text += symbol[i];
      continue;
    }
    const std::size_t end = symbol.find('(', i);
    text += "_{" + symbol.substr(i + 1, end == std::string::npos ? end : end - i - 1) + "}";
    i = end == std::string::npos ? symbol.size() : end - 1;
  }
  text += "  (" + std::string(parameter.title);
  if (!parameter.unit.empty()) text += ", " + std::string(parameter.unit);
  return text + ")";
}

struct Panel {
  const char* column;
  const char* title;
};

constexpr Panel kFourPanels[] = {
    {"mean_tb", "A   body temperature T_{b}"},
    {"huddling", "B   huddling 1 - A"},
    {"groups", "C   groups"},
    {"flow", "D   pup flow |dA/dt|  (1/s)"},
};

constexpr Panel kMaps[] = {
    {"mean_tb", "body temperature T_{b}"},
    {"huddling", "huddling 1 - A"},
    {"groups", "groups"},
    {"largest", "pups in the largest group"},
    {"flow", "pup flow |dA/dt|  (1/s)"},
    {"membership_flow", "membership flow  (1/s)"},
};

/// Nine stops of viridis (CC0, van der Walt & Smith).
constexpr const char* kViridis =
    "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 "
    "'#28ae80', "
    "6 '#5ec962', 7 '#addc30', 8 '#fde725')\n";

std::string opening(const Design& design, int width, int height) {
  std::ostringstream s;
  s << "# Draws " << design.name << ".png and " << design.name << ".svg from summary.csv.\n"
    << "# Run it again after editing:  gnuplot " << design.name << ".gp  (in this folder)\n"
    << "set datafile separator ','\nset datafile commentschars '#'\nset datafile columnheaders\n"
    << "set encoding utf8\nset border 3 lc '#444444'\nset tics nomirror out textcolor '#222222'\n"
    << "do for [format in 'png svg'] {\n"
    << "  if (format eq 'png') {\n    set terminal pngcairo size " << width << ',' << height
    << " font 'DejaVu Sans,11'\n  } else {\n    set terminal svg size " << width << ',' << height
    << " font 'DejaVu Sans,11' background '#ffffff'\n  }\n"
    << "  set output '" << design.name << ".'.format\n";
  return s.str();
}

/// Dashed verticals at T_p and at T_p - G/k1, where a lone pup would be content; labelled in panel
/// A.
std::string marks(const Design& design, bool labelled) {
  std::ostringstream s;
  const double tp = design.base.tp, critical = tp - design.base.g / design.base.k1;
  s << "  set arrow 1 from " << io::number_text(tp) << ", graph 0 to " << io::number_text(tp)
    << ", graph 1 nohead dt 2 lc '#888888' back\n"
    << "  set arrow 2 from " << io::number_text(critical) << ", graph 0 to "
    << io::number_text(critical) << ", graph 1 nohead dt 3 lc '#888888' back\n";
  if (labelled) {
    s << "  set label 1 'T_{p}' at " << io::number_text(tp)
      << ", graph 0.06 left offset 0.4,0 tc '#666666'\n"
      << "  set label 2 'T_{p} - G/k_{1}' at " << io::number_text(critical)
      << ", graph 0.06 right offset -0.4,0 tc '#666666'\n";
  } else {
    s << "  unset label 1\n  unset label 2\n";
  }
  return s.str();
}

std::string four_panels(const Design& design) {
  const Axis& axis = design.axes[0];
  const bool ta = axis.parameter->name == "ta";
  const bool words = axis.parameter->kind == Parameter::Kind::choice;
  const std::string x = words ? "(column(0)):" : "1:";
  const std::string ticks = words ? ":xtic(1)" : "";
  std::ostringstream s;
  s << opening(design, 1100, 860)
    << "  set multiplot layout 2,2 margins 0.08,0.98,0.08,0.95 spacing 0.1,0.12\n"
    << "  set xlabel \"" << label(*axis.parameter) << "\"\n"
    << "  set style fill transparent solid 0.2 noborder\n  set key top left samplen 2 textcolor "
       "'#444444'\n";
  if (words) s << "  set xrange [-0.5:" << axis.values.size() << " - 0.5]\n";
  for (const Panel& panel : kFourPanels) {
    const std::string column(panel.column), sd = column + "_sd";
    s << "\n  set label 3 \"" << panel.title << "\" at graph 0, graph 1.05 left\n";
    const bool first = column == "mean_tb";
    if (ta) s << marks(design, first);
    s << "  plot ";
    if (!words) {
      s << "'summary.csv' using 1:(column('" << column << "') - column('" << sd << "')):(column('"
        << column << "') + column('" << sd
        << "')) with filledcurves lc '#31688e' notitle, \\\n       ";
    } else {
      s << "'summary.csv' using " << x << "(column('" << column << "')):(column('" << sd
        << "')) with yerrorbars pt 0 lw 1.5 lc '#31688e' notitle, \\\n       ";
    }
    if (ta && first) s << "x with lines dt 4 lc '#888888' title 'T_{b} = T_{a}', \\\n       ";
    s << "'summary.csv' using " << x << "(column('" << column << "'))" << ticks
      << (words ? " with points" : " with linespoints lw 1.8")
      << " pt 7 ps 0.6 lc '#31688e' notitle\n";
  }
  s << "  unset multiplot\n  unset output\n}\n";
  return s.str();
}

std::string heat_maps(const Design& design) {
  const Axis& down = design.axes[0];
  const Axis& across = design.axes[1];
  std::ostringstream s;
  s << opening(design, 1400, 860)
    << "  set multiplot layout 2,3 margins 0.06,0.95,0.08,0.94 spacing 0.13,0.13\n"
    << "  " << kViridis << "  set xlabel \"" << label(*across.parameter) << "\"\n  set ylabel \""
    << label(*down.parameter)
    << "\"\n  unset key\n"
    // Cells by index, named by value, so that uneven and listed values fill the plane too.
    << "  set xrange [-0.5:" << across.values.size()
    << " - 0.5]\n  set yrange [-0.5:" << down.values.size() << " - 0.5]\n";
  const auto ticks = [&](const char* axis, const Axis& values) {
    const std::size_t every = (values.values.size() + 7) / 8;
    s << "  set " << axis << "tics (";
    for (std::size_t i = 0; i < values.values.size(); i += every) {
      std::string text = format_value(*values.parameter, values.values[i]);
      if (values.parameter->kind == Parameter::Kind::real) {
        std::ostringstream rounded;
        rounded << values.values[i];
        text = rounded.str();
      }
      s << (i == 0 ? "" : ", ") << '\'' << text << "' " << i;
    }
    s << ")\n";
  };
  ticks("x", across);
  ticks("y", down);
  for (const Panel& panel : kMaps) {
    s << "\n  set title \"" << panel.title
      << "\" offset 0,-0.4\n  plot 'summary.csv' using (int(column(0)) % " << across.values.size()
      << "):(int(column(0)) / " << across.values.size() << "):(column('" << panel.column
      << "')) with image\n";
  }
  s << "  unset multiplot\n  unset output\n}\n";
  return s.str();
}

/// Runs gnuplot on `script` inside `folder`; its exit status, or -1 when it is not installed.
int run_gnuplot(const std::string& folder, const std::string& script) {
  // A shell changes the folder; names go to it as arguments, never as program text.
  std::string shell = "sh", option = "-c", text = "cd -- \"$1\" && exec gnuplot \"$2\"",
              zero = "sh";
  std::string argument1 = folder, argument2 = script;
  char* argv[] = {shell.data(),     option.data(),    text.data(), zero.data(),
                  argument1.data(), argument2.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "sh", nullptr, nullptr, argv, environ) != 0) return -1;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && (WEXITSTATUS(status) == 127 || WEXITSTATUS(status) == 126)) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// Puts the manifest into both pictures, so that they can be made again.
void add_provenance(const std::string& folder, const Design& design) {
  const std::string manifest = manifest_text(design), base = folder + "/" + design.name;
  const io::Image image = io::read_png(base + ".png");
  io::write_png(base + ".png", image,
                {{"Software", "pupflow " PUPFLOW_VERSION}, {"manifest", manifest}}, true);
  std::string svg = io::read_file(base + ".svg", std::size_t{1} << 30);
  const std::size_t root = svg.find("<svg");
  if (root == std::string::npos) return;
  svg.insert(root, "<!--\n" + manifest + "-->\n");
  io::AtomicFile file(base + ".svg", true);
  file.write(svg);
  file.commit();
}

}  // namespace

std::string plot_script(const Design& design) {
  if (design.axes.size() == 1) return four_panels(design);
  if (design.axes.size() == 2) return heat_maps(design);
  return {};
}

std::string draw_plots(const std::string& folder, const Design& design) {
  const std::string script = plot_script(design);
  if (script.empty()) {
    return "no plot: " + std::to_string(design.axes.size()) +
           " varied parameters; one gives four panels, two give maps";
  }
  const std::string name = design.name + ".gp";
  io::AtomicFile file(folder + "/" + name, true);
  file.write(script);
  file.commit();
  const int status = run_gnuplot(folder, name);
  if (status == -1) {
    return "no plot: gnuplot is not installed; install it (Debian: gnuplot-nox) and run this "
           "command again, or 'gnuplot " +
           name + "' in " + folder;
  }
  if (status != 0) {
    throw io::Failure(io::ExitCode::bad_file,
                      folder + "/" + name + ": gnuplot failed with exit code " +
                          std::to_string(status) + "; the CSV files are complete");
  }
  add_provenance(folder, design);
  return {};
}

}  // namespace pupflow::study
