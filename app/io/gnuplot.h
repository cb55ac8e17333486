// Figures drawn by gnuplot.
#pragma once

#include <string>

#include "app/io/png.h"

namespace pupflow::io {

/// One script and the two pictures that it makes.
struct Drawing {
  std::string folder;
  std::string name;  // of NAME.gp, the script in that folder, and of NAME.png and NAME.svg
  TextEntries text;  // what the PNG carries
  std::string note;  // what the SVG carries, as a comment
};

enum class Drawn { done, no_gnuplot, interrupted };

/// Runs the script in its folder. It must write files named by gnuplot's variable `name`, to which
/// ".png" and ".svg" are added; both replace what is there, whole or not at all. Throws
/// Failure(bad_file) when gnuplot fails, with what it complained about, or a picture cannot be
/// written.
Drawn draw(const Drawing& drawing);

/// What to tell where there is no gnuplot: why, what to install, and how to draw then.
std::string no_gnuplot_text(const Drawing& drawing);

/// Nine stops of viridis (CC0, van der Walt & Smith) as a gnuplot command, a line.
extern const char* const kViridisPalette;

}  // namespace pupflow::io
