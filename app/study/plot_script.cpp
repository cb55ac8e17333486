#include "app/study/plot_script.h"

#include <algorithm>
#include <cmath>

#include "app/io/celsius.h"
#include "app/io/gnuplot.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "app/study/plot_labels.h"
#include "app/study/plot_maps.h"
#include "app/study/plot_source.h"
#include "app/study/transition.h"

namespace pupflow::study {
namespace {

/// The panels of the paper's Figure 2.
struct Panel {
  Observable observable;
  std::string_view title;  // in place of the observable's label; may be empty
};
constexpr Panel kFourPanels[] = {
    {Observable::mean_tb, ""},
    {Observable::huddling, ""},
    {Observable::groups, ""},
    {Observable::flow, "pup flow and standard deviation of A"},
};

constexpr const char *kBlue = "#31688e", *kOrange = "#c2570c", *kShade = "#f3ead0";

/// Dashed vertical lines at T_p and at T_p - G/k1, where a pup without contact has T_b = T_p, where
/// they are in the range of the axis; labelled in panel A.
std::string marks(const Design& design, const Axis& axis, bool labelled) {
  const Params params = design.params_of(0);
  const auto [low, high] = std::minmax_element(axis.values.begin(), axis.values.end());
  io::TextStream s;
  const auto mark = [&, low = low, high = high](int number, double at, const char* text,
                                                const char* side, int dash) {
    if (!(at >= *low && at <= *high)) return;
    const std::string x = io::number_text(at);
    s << "  set arrow " << number << " from " << x << ", graph 0 to " << x << ", graph 1 nohead dt "
      << dash << " lc '#888888' back\n  " << (labelled ? "" : "un") << "set label " << number;
    if (labelled) s << " '" << text << "' at " << x << ", graph 0.06 " << side << " tc '#666666'";
    s << '\n';
  };
  mark(1, params.preferred_temperature, "T_{p}", "left offset 0.4,0", 2);
  if (params.air_conductance > 0) {
    mark(2, params.preferred_temperature - params.thermogenesis / params.air_conductance,
         "T_{p} - G/k_{1}", "right offset -0.4,0", 3);
  }
  return s.str();
}

/// Rectangles behind the curves where mean T_b is near T_p.
std::string shades(const std::vector<Range>& held) {
  io::TextStream s;
  for (std::size_t i = 0; i < held.size(); ++i) {
    s << "  set object " << i + 1 << " rectangle from " << io::number_text(held[i].from)
      << ", graph 0 to " << io::number_text(held[i].to) << ", graph 1 behind fc rgb '" << kShade
      << "' fs solid noborder\n";
  }
  return s.str();
}

/// How the curves of one sweep are drawn.
struct Curves {
  std::string source;  // as gnuplot reads it
  std::string varied;
  bool words;  // its values are names, drawn side by side

  /// What follows "plot": mean and spread of one column. `axes` is "x1y1" or "x1y2"; named values
  /// are moved aside by `aside`.
  std::string of(const std::string& column, const char* color, const char* axes, double aside,
                 const std::string& key) const {
    const std::string mean = "column('" + column + "')", sd = "column('" + column + "_sd')";
    const std::string x =
        words ? "(column(0) + " + io::number_text(aside) + "):" : "(column('" + varied + "')):";
    const std::string ticks = words && aside == 0 ? ":xtic(stringcolumn('" + varied + "'))" : "";
    const std::string on = std::string(" axes ") + axes;
    const std::string color_of = std::string(" lc '") + color + "' ";
    io::TextStream s;
    if (words) {
      s << source << " using " << x << "(" << mean << "):(" << sd << ")" << on
        << " with yerrorbars pt 0 lw 1.5" << color_of << "notitle, \\\n       ";
    } else {
      s << source << " using " << x << "(" << mean << " - " << sd << "):(" << mean << " + " << sd
        << ")" << on << " with filledcurves" << color_of << "notitle, \\\n       ";
    }
    s << source << " using " << x << "(" << mean << ")" << ticks << on
      << (words ? " with points" : " with linespoints lw 1.8") << " pt " << (axes[3] == '1' ? 7 : 5)
      << " ps 0.6" << color_of << key;
    return s.str();
  }
};

/// Degrees beside the axis of mean T_b, which begins at 0 or below.
std::string celsius_of_tb(const std::vector<Summary>& summaries) {
  double low = 0, high = 0;
  for (const Summary& summary : summaries) {
    const double mean = summary.statistics[statistic_of(Observable::mean_tb)].mean;
    if (summary.runs == 0 || !std::isfinite(mean)) continue;
    low = std::min(low, mean);
    high = std::max(high, mean);
  }
  // With a second axis gnuplot ends the first one at the data.
  return io::celsius_axis("y", low, high) + "  set offsets 0, 0, graph 0.05, 0\n";
}

/// Commands that start the y axis at 0, or add a label that it does not: T_b may be negative.
std::string start_of_axis(const std::vector<Summary>& summaries, bool first) {
  const bool negative = std::any_of(summaries.begin(), summaries.end(), [](const Summary& s) {
    return s.runs > 0 && s.statistics[statistic_of(Observable::mean_tb)].mean < 0;
  });
  if (!(first && negative)) return "  set yrange [0:*]\n";
  return "  set yrange [*:*]\n  set label 5 'this axis does not start at 0' at graph 0.98, 0.03 "
         "right tc '#666666'\n";
}

std::string four_panels(const Design& design, const Axis& axis,
                        const std::vector<Summary>& summaries) {
  const std::string varied(axis.parameter->name);
  const bool ta = varied == "ta", temperature = io::is_temperature(*axis.parameter);
  const PlotSource source = plot_source(design, summaries, {&axis});
  const Curves curves{source.name, varied, axis.parameter->kind == Parameter::Kind::choice};
  const auto number = static_cast<std::size_t>(&axis - design.axes.data());
  const std::vector<Range> held =
      ta ? held_ranges(design, summaries, number) : std::vector<Range>{};
  const std::string lag = varied == "flow_lag" ? "flow_lag steps"
                          : design.base.flow_lag == 1
                              ? "1 step"
                              : std::to_string(design.base.flow_lag) + " steps";
  const bool has_sd = std::any_of(summaries.begin(), summaries.end(), [](const Summary& summary) {
    return summary.statistics[kExposedSd].mean >= 0;  // NaN where the means are of one step
  });
  std::string note;
  const std::string seeds = seeds_text(summaries);
  if (seeds != "1 seed")
    note = std::string(curves.words ? "bars" : "bands") + ": ± 1 standard deviation over " + seeds;
  if (!held.empty()) {
    note = "shaded: mean T_{b} within " + io::number_text(kHeld) + " of T_{p}" +
           (note.empty() ? "" : ";   ") + note;
  }
  io::TextStream s;
  const auto [low, high] = std::minmax_element(axis.values.begin(), axis.values.end());
  const int border = temperature ? 7 : 3;          // gnuplot's sides: below, left, above; 8: right
  const double above = temperature ? 1.16 : 1.05;  // above the axis in degrees
  s << "  set multiplot layout 2,2 margins 0.05,0.92,0.12,"
    << (temperature ? "0.9 spacing 0.12,0.19" : "0.95 spacing 0.12,0.13") << '\n'
    << "  set border " << border << '\n'
    << (temperature ? io::celsius_axis("x", *low, *high) : "") << "  set xlabel \""
    << label(*axis.parameter) << "\"\n"
    << "  set style fill transparent solid 0.2 noborder\n  set key top left Left reverse samplen 2 "
       "textcolor "
       "'#444444'\n"
    << shades(held);
  if (curves.words) s << "  set xrange [-0.5:" << summaries.size() << " - 0.5]\n";
  if (!note.empty())
    s << "  set label 4 '" << note << "' at screen 0.92, 0.02 right tc '#666666'\n";
  char letter = 'A';
  for (const auto& [observable, title] : kFourPanels) {
    const Field& field = observables()[statistic_of(observable)];
    const std::string column(field.name);
    const bool first = observable == Observable::mean_tb, flow = observable == Observable::flow;
    s << "\n  set label 3 \"" << letter++ << "   "
      << (title.empty() ? label(field) : enhanced(title)) << "\" at graph 0, graph " << above
      << " left\n";
    if (first) s << "  set border " << (border | 8) << '\n' << celsius_of_tb(summaries);
    if (!first) s << "  unset label 4\n  unset label 5\n";  // drawn with the first panel
    if (ta) s << marks(design, axis, first);
    s << start_of_axis(summaries, first);
    if (flow) {
      s << "  set border " << (border | 8)
        << "\n  set y2range [0:*]\n  set y2tics nomirror out textcolor '" << kOrange
        << "'\n  set ytics textcolor '" << kBlue << "'\n"
        << "  set ylabel 'pup flow |ΔA|/Δt over " << lag << "  (1/s)' textcolor '" << kBlue
        << "' offset 1,0\n"
        << "  set y2label '" << label(run_statistics()[kExposedSd]) << "' textcolor '" << kOrange
        << "'\n";
    }
    s << "  plot ";
    if (ta && first) s << "x with lines dt 4 lc '#888888' title 'T_{b} = T_{a}', \\\n       ";
    s << curves.of(column, kBlue, "x1y1", 0, flow ? "title 'pup flow (left)'" : "notitle");
    if (flow && has_sd) {
      s << ", \\\n       "
        << curves.of(std::string(run_statistics()[kExposedSd].name), kOrange, "x1y2", 0.08,
                     "title 'sd of A (right)'");
    }
    s << '\n';
    if (first) s << io::no_celsius_axis("y") << "  unset offsets\n  set border " << border << '\n';
  }
  // Back to the settings before panel D, for the other format.
  if (temperature) s << io::no_celsius_axis("x");
  s << "  set border 3\n  unset y2tics\n  unset y2label\n  unset ylabel\n"
    << "  set y2range [*:*]\n  set ytics textcolor '#222222'\n";
  s << "  unset multiplot\n";
  return io::gnuplot_script(design.name, source.block.empty() ? "summary.csv" : "the rows below",
                            1200, 900, s.str(), source.block);
}

}  // namespace

std::string plot_script(const Design& design, const std::vector<Summary>& summaries) {
  const std::vector<const Axis*> axes = plotted_axes(design);
  if (axes.size() == 1) return four_panels(design, *axes[0], summaries);
  if (axes.size() == 2) return map_script(design, summaries, *axes[0], *axes[1]);
  return {};
}

}  // namespace pupflow::study
