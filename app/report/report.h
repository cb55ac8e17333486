// A report: a folder with a page (report.md), its figures and the CSV files that they are drawn from.
#pragma once

#include <string>
#include <vector>

#include "app/io/csv.h"
#include "app/io/table.h"
#include "pupflow/parameters.h"

namespace pupflow::report {

/// The options of a report.
struct Options {
  std::string folder;   // of the report
  std::string command;  // that makes the same report
  int threads = 1;
  bool quick = false;  // fewer and shorter runs: seconds instead of minutes
  bool force = false;  // replace the files of an earlier report
  bool quiet = false;
};

/// Throws io::Failure(interrupted) after Ctrl-C. To be called between runs. Finished files are kept.
void stop_if_interrupted();

/// Writes the files of one report. All members that write throw io::Failure(bad_file).
class Report {
 public:
  /// Makes the folder. Throws io::Failure(bad_file) when it is not empty and not `force`, or cannot
  /// be made.
  Report(const Options& options, const std::string& title);

  const Options& options() const { return options_; }

  // Add to the page.
  void heading(const std::string& text);     // level 2
  void subheading(const std::string& text);  // level 3
  void text(const std::string& paragraph);   // Markdown
  void table(const std::vector<io::Row>& rows);

  /// A CSV file NAME.csv in the folder. Its header has the version, the command and the parameters.
  /// Commit it before a figure reads it.
  io::CsvFile csv(const std::string& name, const Params& params, std::string_view columns) const;

  /// Draws a figure NAME and adds it to the page; without gnuplot a line that says so. `body` holds
  /// the plot commands (io::gnuplot_script), which read CSV files of the folder. The size is in
  /// pixels. The script is kept as NAME.gp. Also throws io::Failure(interrupted).
  void figure(const std::string& name, const std::string& caption, const std::string& body,
              const Params& params, int width = 760, int height = 500);

  /// Writes report.md. To be called last.
  void finish();

 private:
  Options options_;
  std::string page_;
};

/// A number in `digits` significant digits, for tables; "-" where it is not finite.
std::string rounded(double value, int digits = 3);

}  // namespace pupflow::report
