// A report: one folder with a page (report.md) that is readable on its own, its figures and the
// numbers behind them.
#pragma once

#include <string>
#include <vector>

#include "app/io/csv.h"
#include "app/io/table.h"
#include "pupflow/parameters.h"

namespace pupflow::report {

/// What the user asked for.
struct Options {
  std::string folder;   // where the report goes
  std::string command;  // the words that make the same report again
  int threads = 1;
  bool quick = false;  // fewer and shorter runs: minutes become seconds
  bool force = false;  // replace the files of an earlier report
  bool quiet = false;
};

/// Throws io::Failure(interrupted) when Ctrl-C came: call it between runs. What was written stays.
void stop_if_interrupted();

/// Writes the files of one report. All members that write throw io::Failure(bad_file).
class Report {
 public:
  /// Makes the folder. Throws io::Failure(bad_file) when it holds anything and not `force`, or
  /// cannot be made.
  Report(const Options& options, const std::string& title);

  const Options& options() const { return options_; }

  // Pieces of the page, in order.
  void heading(const std::string& text);     // level 2
  void subheading(const std::string& text);  // level 3
  void text(const std::string& paragraph);   // Markdown
  void table(const std::vector<io::Row>& rows);

  /// A CSV file NAME.csv in the folder, whose header says which program, command and parameters
  /// made it. Commit it before a figure reads it.
  io::CsvFile csv(const std::string& name, const Params& params, std::string_view columns) const;

  /// Draws a figure NAME and puts it on the page, with a line where there is no gnuplot. `body` are
  /// gnuplot commands that plot CSV files of the folder, for a picture of the given size in pixels;
  /// `caption` says what is seen. The script stays beside it as NAME.gp. Throws
  /// io::Failure(interrupted), too.
  void figure(const std::string& name, const std::string& caption, const std::string& body,
              const Params& params, int width = 760, int height = 500);

  /// Writes report.md. Last.
  void finish();

 private:
  Options options_;
  std::string page_;
};

/// A number in `digits` significant digits, for tables; "-" where it is not finite.
std::string rounded(double value, int digits = 3);

}  // namespace pupflow::report
