// Figures drawn by gnuplot.
#pragma once

#include <string>

#include "app/io/png.h"

namespace pupflow::io {

/// The text of NAME.gp, which draws NAME.png and NAME.svg. `body` holds the plot commands, each line
/// indented by two spaces; they run once for either picture, `data` before both. `source` names what they read, e.g.
/// "summary.csv". CSV files have a line of column names, and comments that begin with #. `width` and
/// `height` are the size of both pictures in pixels.
std::string gnuplot_script(const std::string& name, const std::string& source, int width,
                           int height, const std::string& body, const std::string& data = "");

/// A script in a folder, and what its two pictures carry.
struct Drawing {
  std::string folder;
  std::string name;         // of NAME.gp, the script in that folder, and of NAME.png and NAME.svg
  TextEntries text;         // what the PNG carries
  std::string note;         // what the SVG carries, as a comment
  std::string script = {};  // a file to run in place of NAME.gp
};

enum class Drawn { done, no_gnuplot, interrupted };

/// Runs the script with the folder as its working folder, without the user's settings of gnuplot. It
/// must write the files `name`.png and `name`.svg, where `name` is a variable of gnuplot that is set
/// here. Each replaces the earlier file whole or not at all. A script can run any command: pass
/// nothing that came from a file, unless the user named that file as a script.
/// Throws Failure(bad_file) when gnuplot fails, with its message, or a picture cannot be written.
Drawn draw(const Drawing& drawing);

/// The message where gnuplot is not installed: what to install, and how to draw then.
std::string no_gnuplot_text(const Drawing& drawing);

/// Gnuplot commands, a line each and indented by two spaces, for a second axis in °C across from
/// `axis`, "x" or "y", which shows temperatures from about `low` to `high`; and those that take it
/// away again. Titles need room above the second axis of x.
std::string celsius_axis(const std::string& axis, double low, double high);
std::string no_celsius_axis(const std::string& axis);

/// A gnuplot command, one line: the color map viridis (CC0, van der Walt & Smith) by nine stops.
extern const char* const kViridisPalette;

}  // namespace pupflow::io
