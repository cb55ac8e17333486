// pupflow figure1: the paper's Figure 1.
#include <memory>

#include "app/cli/graphics_module.h"
#include "app/cli/look_options.h"
#include "app/cli/parse.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/frame_path.h"
#include "app/io/params_of_file.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

using io::ExitCode;
using io::Failure;

struct Figure1Options {
  Common common;
  LookOptions look;
  std::string ta = "0.2,0.5,0.8";
  int panel = pictures::Figure1Job{}.panel;
};

std::vector<double> panels(const std::string& text, const Params& params) {
  constexpr std::size_t kMostPanels = 12;
  std::vector<double> ta =
      parse_numbers("--ta", text, "temperatures joined by commas, e.g. 0.2,0.5,0.8");
  if (ta.size() > kMostPanels) {
    throw Failure(ExitCode::bad_input, "--ta " + text + ": at most 12 panels fit a figure");
  }
  for (const double value : ta) {
    Params panel = params;
    panel.ambient_temperature = value;
    if (const auto problems = check(panel); !problems.empty()) throw InvalidParams(problems);
  }
  return ta;
}

/// Takes what was not typed from the figure of --like: its look, its panels.
void take_figure(const CLI::App& verb, Figure1Options& options) {
  const std::string& like = options.common.settings.like;
  if (like.empty()) return;
  const io::TextEntries figure = io::entries_of_file(like);
  const std::string* picture = find_entry(figure, "picture");
  if (picture == nullptr || *picture != "figure1") return;
  take_look(verb, figure, options.look);
  const std::string* ta = find_entry(figure, "panels_ta");
  if (ta != nullptr && verb.count("--ta") == 0) options.ta = *ta;
  const std::string* panel = find_entry(figure, "panel");
  if (panel != nullptr && verb.count("--panel") == 0) {
    options.panel = io::read_number<int>(*panel).value_or(options.panel);
  }
}

void work(const CLI::App& verb, Figure1Options options) {
  take_figure(verb, options);
  for (const std::string& set : options.common.settings.sets) {
    if (!set.starts_with("ta=")) continue;
    throw Failure(ExitCode::bad_input,
                  "--set " + set + ": each panel has its own ta; use --ta " + set.substr(3));
  }
  pictures::Figure1Job job;
  job.params = io::set_up(options.common.settings).params;
  job.ta = panels(options.ta, job.params);
  job.panel = options.panel;
  job.threads = thread_count(options.common);
  job.look = look_of(options.look);
  job.output = {options.common.out, options.common.force, options.common.quiet};
  check_picture_name("--out", job.output.path);
  if (io::has_number(job.output.path)) {
    io::refuse("--out " + job.output.path + ": the figure is one picture; name it without %");
  }
  io::refuse_existing(job.output.path, job.output.force);
  load_graphics().figure1(job);
  if (!job.output.quiet) io::print("wrote " + job.output.path + "\n");
}

}  // namespace

Verb add_figure1(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "figure1", "Draw the paper's Figure 1: litters at three temperatures, seen from above");
  const auto options = std::make_shared<Figure1Options>();
  options->common.out = "figure1.png";
  CommonHelp help;
  help.scene = false;
  help.threads = "Threads that step the panels (default: all cores); the picture stays the same";
  help.out = "The picture's file (default figure1.png)";
  help.quiet = "No progress";
  add_common(*app, options->common, help);
  app->add_option("--ta", options->ta, "Ambient temperatures, a panel each (default 0.2,0.5,0.8)")
      ->option_text("TA,TA,...");
  app->add_option("--panel", options->panel,
                  "Edge of a panel in pixels, " + std::to_string(pictures::kSmallestPanel) +
                      " to " + std::to_string(pictures::kLargestPanel) + " (default " +
                      std::to_string(options->panel) + ")")
      ->option_text("N")
      ->check(between(pictures::kSmallestPanel, pictures::kLargestPanel));
  add_look(*app, options->look, false);
  add_picture_look(*app, options->look);
  return {
      app,
      [options, app] {
        try {
          work(*app, *options);
        } catch (const Failure& failure) {
          throw about_like(*app, options->common.settings.like, failure);
        }
      },
      {{"figure1", "The figure, as figure1.png"},
       {"figure1 --color-by group --out groups.png", "The same litters, their groups in colors"}}};
}

}  // namespace pupflow::cli
