#include "app/study/plot.h"

#include <algorithm>
#include <filesystem>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/gnuplot.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"
#include "app/study/files.h"
#include "app/study/plot_script.h"
#include "app/study/plot_source.h"

namespace pupflow::study {

namespace fs = std::filesystem;

constexpr std::size_t kLargestScript = std::size_t{1} << 30;

std::string draw_plots(const std::string& folder, const Design& design,
                       const std::vector<Summary>& summaries, const std::string& named) {
  const std::string text = plot_script(design, summaries);
  if (text.empty()) {
    return "no plot: " + std::to_string(plotted_axes(design).size()) +
           " parameters take several values; one gives four panels, two give maps";
  }
  if (std::none_of(summaries.begin(), summaries.end(), [](const Summary& s) { return s.runs > 0; }))
    return "no plot: no run was fine";
  const std::string path = script_path(folder, design);
  if (!fs::exists(path)) {
    io::AtomicFile file(path, false);
    file.write(text);
    file.commit();
  } else if (named.empty() && io::read_file(path, kLargestScript) != text) {
    return "no plot: " + path + " was edited, so it is not run by itself; add --plot-script " +
           path + ", or run 'gnuplot " + design.name + ".gp' in " + folder;
  }
  const std::string manifest = manifest_text(design);
  const io::Drawing drawing{folder, design.name,
                            io::provenance(design.base, {{"manifest", manifest}}), manifest, named};
  switch (io::draw(drawing)) {
    case io::Drawn::done:
      return {};
    case io::Drawn::no_gnuplot:
      return io::no_gnuplot_text(drawing);
    case io::Drawn::interrupted:
      break;
  }
  throw io::Failure(io::ExitCode::interrupted,
                    "interrupted while drawing; the CSV files are complete, and the same command "
                    "draws the figure");
}

}  // namespace pupflow::study
