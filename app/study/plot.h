// The figures of a sweep, drawn by gnuplot from its summary.
#pragma once

#include <string>

#include "app/study/results.h"

namespace pupflow::study {

/// The gnuplot script for a design: four panels against one varied parameter, heat maps of each
/// observable over two. It reads summary.csv in its own folder and writes NAME.png and NAME.svg
/// there. Empty when neither fits.
std::string plot_script(const Design& design);

/// Writes the script into `folder` and runs gnuplot on it, then adds the manifest to both pictures.
/// Returns an empty text, or one line saying why there is no picture (more than two varied
/// parameters; gnuplot is missing). Throws io::Failure(bad_file) when a file cannot be written or
/// gnuplot fails.
std::string draw_plots(const std::string& folder, const Design& design);

}  // namespace pupflow::study
