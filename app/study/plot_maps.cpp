#include "app/study/plot_maps.h"

#include <algorithm>
#include <cmath>

#include "app/io/gnuplot.h"
#include "app/io/text.h"
#include "app/io/text_stream.h"
#include "app/study/plot_labels.h"
#include "app/study/plot_source.h"

namespace pupflow::study {
namespace {

// Sizes in pixels, for a font of 11 points.
constexpr int kWidth = 1400, kHeight = 860, kColumns = 3, kRows = 2;
constexpr int kLetter = 9, kLine = 22;                 // room of a letter, of a line of text
constexpr int kBar = 16, kBarGap = 8, kBarLabel = 88;  // the color bar of a panel
constexpr int kTitle = 44;                             // above a panel
constexpr int kAxisLabels = 62;                        // below the lowest
constexpr int kBetween = 16;                           // between two in a row

/// Ticks of one axis: places, and what stands there.
struct Ticks {
  std::vector<std::string> texts;  // of every value
  std::size_t every;               // this many values from tick to tick
  std::size_t longest = 0;         // text, in letters

  /// `pixels` is the room of all values, `room` that of a tick whose text has so many letters.
  template <class Room>
  Ticks(const Axis& axis, int pixels, Room room)
      : texts(short_values(*axis.parameter, drawn_values(axis))) {
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    const auto most =
        static_cast<std::size_t>(std::max(1, pixels / room(static_cast<int>(longest))));
    every = (texts.size() + most - 1) / most;
  }

  /// What gnuplot takes for them, with the texts or without.
  std::string list(bool with_texts) const {
    std::string list;
    for (std::size_t i = 0; i < texts.size(); i += every)
      list += (i == 0 ? "'" : ", '") + (with_texts ? texts[i] : "") + "' " + std::to_string(i);
    return list;
  }
};

/// From tick to tick, so that there are three or a few more: 1, 2 or 5 times a power of ten.
double tick_step(const std::vector<double>& values) {
  const double most = (values.back() - values.front()) / 3;
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= most) return step * power;
  }
  return power;
}

/// What gnuplot computes for the place of a point that is no cell: its value, or the place of its
/// name among the choices.
std::string place_of(const Axis& axis) {
  const std::string name(axis.parameter->name);
  if (axis.parameter->kind != Parameter::Kind::choice) return "(column('" + name + "'))";
  const std::vector<double> values = drawn_values(axis);
  std::string place = "(";
  for (std::size_t i = 0; i < values.size(); ++i) {
    place += "strcol('" + name + "') eq '" + format_value(*axis.parameter, values[i]) + "' ? " +
             std::to_string(i) + " : ";
  }
  return place + "NaN)";
}

class Maps {
 public:
  Maps(const Design& design, const std::vector<Summary>& summaries, const Axis& down,
       const Axis& across)
      : down_(down),
        across_(across),
        cells_(design.layout == Layout::grid),
        source_(plot_source(design, summaries, {&down, &across})),
        seeds_(seeds_text(summaries)),
        failed_(std::any_of(summaries.begin(), summaries.end(),
                            [](const Summary& s) { return s.runs == 0; })),
        y_ticks_(down, panel_height(), [](int) { return kLine; }),
        left_(kLine + kLetter * static_cast<int>(std::max<std::size_t>(y_ticks_.longest, 5)) + 20),
        x_ticks_(across, panel_width(), [](int letters) { return kLetter * (letters + 1); }) {}

  std::string script(const std::string& name) {
    s_ << "  set multiplot\n  " << io::kViridisPalette << "  unset key\n"
       << "  set label 4 '"
       << (seeds_ == "1 seed" ? "one run at each point" : "means over " + seeds_)
       << (failed_ ? ";   blank: no run was fine" : "")
       << "' at screen 0.99, 0.015 right tc '#666666'\n";
    range("x", across_);
    range("y", down_);
    int place = 0;
    for (const Field& field : observables()) {
      panel(field, place % kColumns, place / kColumns);
      ++place;
    }
    s_ << "  unset multiplot\n";
    return io::gnuplot_script(name, source_.block.empty() ? "summary.csv" : "the rows below",
                              kWidth, kHeight, s_.str(), source_.block);
  }

 private:
  static int panel_height() { return (kHeight - kAxisLabels - kLine) / kRows - kTitle; }
  int column_width() const { return (kWidth - left_) / kColumns; }
  int panel_width() const { return column_width() - kBarGap - kBar - kBarLabel - kBetween; }

  /// Cells are drawn by number, so that unevenly spaced values fill the plane too.
  bool by_number(const Axis& axis) const {
    return cells_ || axis.parameter->kind == Parameter::Kind::choice;
  }

  void range(const char* name, const Axis& axis) {
    const std::vector<double> values = drawn_values(axis);
    s_ << "  set " << name << "range ";
    if (by_number(axis)) {
      s_ << "[-0.5:" << values.size() << " - 0.5]\n";
    } else {
      const double margin = (values.back() - values.front()) / 20;
      s_ << "[" << io::number_text(values.front() - margin) << ":"
         << io::number_text(values.back() + margin) << "]\n";
    }
  }

  /// Ticks and label of an axis on the panels at the edge, ticks alone elsewhere.
  void axis(const char* name, const Axis& axis, const Ticks& ticks, bool edge) {
    s_ << "  set " << name << "label \"" << (edge ? label(*axis.parameter, true) : "")
       << "\"\n  set " << name << "tics ";
    if (by_number(axis)) {
      s_ << "(" << ticks.list(edge) << ")\n";
    } else {
      s_ << io::number_text(tick_step(drawn_values(axis))) << "\n  set format " << name
         << (edge ? " '%g'\n" : " ''\n");
    }
  }

  void panel(const Field& field, int column, int row) {
    const double left = left_ + column * column_width(), right = left + panel_width();
    const double top = kHeight - row * (kTitle + panel_height()) - kTitle,
                 bottom = top - panel_height();
    const auto x = [](double at) { return io::formatted("%.5f", at / kWidth); };
    const auto y = [](double at) { return io::formatted("%.5f", at / kHeight); };
    s_ << "\n  set lmargin at screen " << x(left) << "\n  set rmargin at screen " << x(right)
       << "\n  set tmargin at screen " << y(top) << "\n  set bmargin at screen " << y(bottom)
       << "\n  set colorbox user origin " << x(right + kBarGap) << ", " << y(bottom) << " size "
       << x(kBar) << ", " << y(panel_height()) << "\n  set format cb '%.4g'\n";
    axis("x", across_, x_ticks_, row == kRows - 1);
    axis("y", down_, y_ticks_, column == 0);
    s_ << "  set title \"" << label(field, true) << "\" offset 0,-0.4\n  plot " << source_.name
       << " using ";
    const std::size_t width = drawn_values(across_).size();
    if (cells_) {
      s_ << "(int(column(0)) % " << width << "):(int(column(0)) / " << width << "):(column('"
         << field.name << "')) with image\n";
    } else {
      s_ << place_of(across_) << ":" << place_of(down_) << ":(column('" << field.name
         << "')) with points pt 7 ps 1.2 lc palette\n";
    }
    if (column + row == 0) s_ << "  unset label 4\n";
  }

  const Axis &down_, &across_;
  bool cells_;
  PlotSource source_;
  std::string seeds_;
  bool failed_;
  Ticks y_ticks_;
  int left_;
  Ticks x_ticks_;
  io::TextStream s_;
};

}  // namespace

std::string map_script(const Design& design, const std::vector<Summary>& summaries,
                       const Axis& down, const Axis& across) {
  return Maps(design, summaries, down, across).script(design.name);
}

}  // namespace pupflow::study
