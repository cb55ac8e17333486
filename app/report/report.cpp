#include "app/report/report.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/gnuplot.h"
#include "app/io/interrupt.h"
#include "app/io/machine.h"
#include "app/io/provenance.h"

namespace pupflow::report {
namespace {

namespace fs = std::filesystem;

void make_empty_folder(const std::string& folder, bool force) {
  std::error_code error;
  fs::create_directories(folder, error);
  const bool empty = !error && fs::is_empty(folder, error);
  if (error) {
    throw io::Failure(io::ExitCode::bad_file,
                      folder + ": cannot make this folder: " + error.message());
  }
  if (empty || force) return;
  throw io::Failure(io::ExitCode::bad_file,
                    folder +
                        ": holds files already; name another folder with --out, or use --force "
                        "to replace the report there");
}

io::TextEntries made_by(const Options& options, const Params& params) {
  return io::provenance(params, {{"command", options.command}});
}

std::string machine_text(const Options& options) {
  return "Made by `" + options.command + "`.\n\n" +
         io::markdown_table({{"", ""},
                             {"version", io::program_version()},
                             {"compiler", io::compiler_words()},
                             {"processor", io::cpu_name()},
                             {"cores", std::to_string(std::thread::hardware_concurrency())},
                             {"kernels", io::kernel_words()}});
}

}  // namespace

void stop_if_interrupted() {
  if (!io::interrupted()) return;
  throw io::Failure(io::ExitCode::interrupted,
                    "interrupted; the CSV files and figures of finished scenes are kept");
}

Report::Report(const Options& options, const std::string& title) : options_(options) {
  make_empty_folder(options.folder, options.force);
  page_ = "# " + title + "\n\n" + machine_text(options);
}

void Report::heading(const std::string& text) {
  page_ += "\n## " + text + "\n";
}

void Report::subheading(const std::string& text) {
  page_ += "\n### " + text + "\n";
}

void Report::text(const std::string& paragraph) {
  page_ += "\n" + paragraph + "\n";
}

void Report::table(const std::vector<io::Row>& rows) {
  page_ += "\n" + io::markdown_table(rows);
}

io::CsvFile Report::csv(const std::string& name, const Params& params,
                        std::string_view columns) const {
  return {options_.folder + "/" + name + ".csv", options_.force, made_by(options_, params),
          columns};
}

void Report::figure(const std::string& name, const std::string& caption, const std::string& body,
                    const Params& params, int width, int height) {
  io::AtomicFile file(options_.folder + "/" + name + ".gp", options_.force);
  file.write(io::gnuplot_script(name, "the CSV files in this folder", width, height,
                                "  set datafile missing 'nan'\n" + body));
  file.commit();
  const io::Drawing drawing{options_.folder, name, made_by(options_, params),
                            "command = " + options_.command + "\n"};
  switch (io::draw(drawing)) {
    case io::Drawn::done:
      text("![" + caption + "](" + name + ".png)");
      return;
    case io::Drawn::no_gnuplot:
      text("(" + io::no_gnuplot_text(drawing) + ")");
      return;
    case io::Drawn::interrupted:
      break;
  }
  stop_if_interrupted();
}

void Report::finish() {
  io::AtomicFile file(options_.folder + "/report.md", options_.force);
  file.write(page_);
  file.commit();
}

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace pupflow::report
