#include "app/study/plot_script.h"

#include <algorithm>
#include <sstream>

#include "app/io/gnuplot.h"
#include "app/io/text.h"

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
    {"mean_tb", "A   body temperature T_{b}  (0.6 is 37 °C)"},
    {"huddling", "B   huddling 1 - A"},
    {"groups", "C   groups"},
    {"flow", "D   pup flow |dA/dt|  (1/s)"},
};

constexpr Panel kMaps[] = {
    {"mean_tb", "body temperature T_{b}  (0.6 is 37 °C)"},
    {"huddling", "huddling 1 - A"},
    {"groups", "groups"},
    {"largest", "pups in the largest group"},
    {"flow", "pup flow |dA/dt|  (1/s)"},
    {"membership_flow", "membership flow  (1/s)"},
};

std::string opening(const Design& design, int width, int height) {
  std::ostringstream s;
  s << "# Draws " << design.name << ".png and " << design.name << ".svg from summary.csv.\n"
    << "# Run it again after editing:  gnuplot " << design.name << ".gp  (in this folder)\n"
    << "if (!exists('name')) name = '" << design.name << "'\n"
    << "set datafile separator ','\nset datafile commentschars '#'\nset datafile columnheaders\n"
    << "set encoding utf8\nset border 3 lc '#444444'\nset tics nomirror out textcolor '#222222'\n"
    << "do for [format in 'png svg'] {\n"
    << "  if (format eq 'png') {\n    set terminal pngcairo size " << width << ',' << height
    << " font 'DejaVu Sans,11'\n  } else {\n    set terminal svg size " << width << ',' << height
    << " font 'DejaVu Sans,11' background '#ffffff'\n  }\n"
    << "  set output name.'.'.format\n";
  return s.str();
}

/// Dashed verticals at T_p and at T_p - G/k1, where a lone pup would be content, as far as the axis
/// reaches; labelled in panel A.
std::string marks(const Design& design, const Axis& axis, bool labelled) {
  const Params params = design.params_of(0);
  const auto [low, high] = std::minmax_element(axis.values.begin(), axis.values.end());
  std::ostringstream s;
  const auto mark = [&](int number, double at, const char* text, const char* side, int dash) {
    if (!(at >= *low && at <= *high)) return;
    const std::string x = io::number_text(at);
    s << "  set arrow " << number << " from " << x << ", graph 0 to " << x << ", graph 1 nohead dt "
      << dash << " lc '#888888' back\n  " << (labelled ? "" : "un") << "set label " << number;
    if (labelled) s << " '" << text << "' at " << x << ", graph 0.06 " << side << " tc '#666666'";
    s << '\n';
  };
  mark(1, params.tp, "T_{p}", "left offset 0.4,0", 2);
  if (params.k1 > 0) {
    mark(2, params.tp - params.g / params.k1, "T_{p} - G/k_{1}", "right offset -0.4,0", 3);
  }
  return s.str();
}

std::string four_panels(const Design& design, const Axis& axis) {
  const std::string varied(axis.parameter->name);
  const bool ta = varied == "ta";
  const bool words = axis.parameter->kind == Parameter::Kind::choice;
  const std::string x = words ? "(column(0)):" : "(column('" + varied + "')):";
  const std::string ticks = words ? ":xtic(stringcolumn('" + varied + "'))" : "";
  std::ostringstream s;
  s << opening(design, 1100, 860)
    << "  set multiplot layout 2,2 margins 0.08,0.98,0.11,0.95 spacing 0.1,0.12\n"
    << "  set xlabel \"" << label(*axis.parameter) << "\"\n"
    << "  set style fill transparent solid 0.2 noborder\n  set key top left samplen 2 textcolor "
       "'#444444'\n";
  if (words) s << "  set xrange [-0.5:" << axis.values.size() << " - 0.5]\n";
  if (design.seeds > 1) {
    s << "  set label 4 '" << (words ? "bars" : "bands") << ": ± 1 standard deviation over "
      << design.seeds << " seeds' at screen 0.985, 0.018 right tc '#666666'\n";
  }
  for (const Panel& panel : kFourPanels) {
    const std::string column(panel.column), sd = column + "_sd";
    s << "\n  set label 3 \"" << panel.title << "\" at graph 0, graph 1.05 left\n";
    const bool first = column == "mean_tb";
    if (!first) s << "  unset label 4\n";  // drawn with the first panel
    if (ta) s << marks(design, axis, first);
    s << "  plot ";
    if (!words) {
      s << "'summary.csv' using " << x << "(column('" << column << "') - column('" << sd
        << "')):(column('" << column << "') + column('" << sd
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

std::string heat_maps(const Design& design, const Axis& down, const Axis& across) {
  std::ostringstream s;
  s << opening(design, 1400, 860)
    << "  set multiplot layout 2,3 margins 0.06,0.95,0.08,0.94 spacing 0.13,0.13\n"
    << "  " << io::kViridisPalette << "  set xlabel \"" << label(*across.parameter)
    << "\"\n  set ylabel \"" << label(*down.parameter)
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

}  // namespace

std::vector<const Axis*> plotted_axes(const Design& design) {
  std::vector<const Axis*> axes;
  for (const Axis& axis : design.axes) {
    if (axis.values.size() > 1) axes.push_back(&axis);
  }
  return axes;
}

std::string plot_script(const Design& design) {
  const std::vector<const Axis*> axes = plotted_axes(design);
  if (axes.size() == 1) return four_panels(design, *axes[0]);
  if (axes.size() == 2) return heat_maps(design, *axes[0], *axes[1]);
  return {};
}

}  // namespace pupflow::study
