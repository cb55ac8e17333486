// pupflow export: a recording in a form that other programs read.
#include "app/export/export.h"

#include <memory>

#include "app/cli/verb.h"
#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

struct ExportOptions {
  std::string recording, format, scale;
  exporting::Request request;
  bool quiet = false;
};

exporting::Range read_range(const std::string& text) {
  const std::vector<std::string_view> ends = io::split(text, ',');
  if (ends.size() == 2) {
    const auto low = io::read_number<double>(ends[0]), high = io::read_number<double>(ends[1]);
    if (low && high && *low < *high) return {*low, *high};
  }
  io::refuse("--scale " + text + ": must be MIN,MAX with MIN below MAX, e.g. 0,1");
}

std::string format_names(const char* separator) {
  return io::joined(exporting::formats(), separator,
                    [](const exporting::Format& format) { return std::string(format.name); });
}

void work(ExportOptions options) {
  if (!options.scale.empty()) {
    if (options.format != "gcal") io::refuse("--scale: has no effect without --format gcal");
    options.request.scale = read_range(options.scale);
  }
  const io::RecordedRun recording(options.recording);
  io::Progress progress("export", static_cast<std::int64_t>(recording.frames()), options.quiet);
  exporting::export_recording(recording, options.format, options.request, progress);
}

}  // namespace

Verb add_export(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("export", "Write a recording in a form that other programs read");
  const auto options = std::make_shared<ExportOptions>();
  exporting::Request& request = options->request;
  app->add_option("RECORDING", options->recording, "A file of 'pupflow run --record'")
      ->option_text(" ")
      ->required()
      ->check(not_empty);
  app->add_option("--format", options->format, "The form, one of those below")
      ->option_text(format_names("|"))
      ->required()
      ->check(not_empty);
  app->add_option("-o,--out", request.out,
                  "Write to this file; %05d stands for the step of a frame")
      ->option_text("FILE")
      ->required()
      ->check(not_empty);
  app->add_option("--field", request.field,
                  "The field, e.g. tb; 'pupflow info' lists those of the recording (default: "
                  "temperature where it was recorded, else tb)")
      ->option_text("FIELD")
      ->check(not_empty);
  app->add_option("--pup", request.pup, "One pup instead of all")
      ->option_text("N")
      ->check(between(0, 1 << 30));
  app->add_flag("--sheet", request.sheet,
                "Afferents as square images of the skin; the recording's data set skin/sheet says "
                "which afferent is where");
  app->add_option(
         "--scale", options->scale,
         "With --format gcal: the values that become 0 and 1; those beyond are cut off (default: "
         "the field's range)")
      ->option_text("MIN,MAX");
  app->add_flag("--force", request.force, "Replace output files that exist");
  app->add_flag("-q,--quiet", options->quiet, "No progress");
  std::string footer = "Formats:\n";
  for (const exporting::Format& format : exporting::formats()) {
    footer += "  " + std::string(format.name) + ": " + std::string(format.doc) + "\n";
  }
  app->footer(footer);
  return {app,
          [options] { work(*options); },
          {{"export run.h5 --format npy --out tb.npy", "Body temperatures as a numpy array"},
           {"export run.h5 --format vtk --out 'pups-%05d.vtp'", "A file a frame, for ParaView"}}};
}

}  // namespace pupflow::cli
