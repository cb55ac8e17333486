// pupflow live: the window.
#include <memory>

#include "app/cli/graphics_module.h"
#include "app/cli/look_options.h"
#include "app/cli/parse.h"
#include "app/cli/start.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/frame_path.h"

namespace pupflow::cli {
namespace {

struct LiveOptions {
  Common common;  // its `out` is the pattern for screenshots
  LookOptions look;
  std::string size = size_text(window::LiveJob{}.width, window::LiveJob{}.height);
  double ui_scale = 0;
  std::string from;
  bool paused = false;
  bool test_events = false;
  double exit_after = 0;
};

void work(const CLI::App& verb, const LiveOptions& options) {
  window::LiveJob job;
  const Start start = start_of(options.common.settings, options.from);
  job.params = start.recipe;
  job.from = start.from;
  const io::Settings& typed = options.common.settings;
  for (const std::string& name : {typed.scene, typed.like, options.from}) {
    if (!name.empty()) job.opened = name;
  }
  job.look = look_of(options.look);
  std::tie(job.width, job.height) = parse_size("--size", options.size);
  job.ui_scale = options.ui_scale;
  const auto given = [&](const char* option) { return verb.count(option) > 0; };
  job.given = {.size = given("--size"),
               .ui_scale = given("--ui-scale"),
               .quality = given("--quality"),
               .draw = given("--draw"),
               .colormap = given("--colormap")};
  job.paused = options.paused;
  job.threads = thread_count(options.common);
  job.screenshot = options.common.out;
  check_picture_name("--screenshots", job.screenshot);
  if (!job.screenshot.empty())
    io::refuse_existing(io::frame_path(job.screenshot, 0), true);  // as far as it is known now
  job.test_events = options.test_events;
  job.exit_after = options.exit_after;
  load_graphics().live(job);
}

}  // namespace

Verb add_live(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("live", "Open the window: watch, orbit, pause, drag sliders");
  const auto options = std::make_shared<LiveOptions>();
  CommonHelp help;
  help.threads = "Threads that share a step (default: all cores, where the litter is large enough)";
  help.out_names = "-o,--screenshots,--out";
  help.out = "Where the screenshot key writes; %d or %0Nd stands for the step";
  help.quiet = "No effect here; the window prints nothing but errors";
  add_common(*app, options->common, help);
  app->add_option(
         "--size", options->size,
         "Window size in pixels (default: that of the last window, at first " + options->size + ")")
      ->option_text("WxH");
  app->add_option(
         "--ui-scale", options->ui_scale,
         "Size of text and widgets, 0.5 to 4, less in a window too narrow for it (default: "
         "the last one chosen, at first the display's)")
      ->option_text("X")
      ->check(between(window::kSmallestScale, window::kLargestScale));
  add_from(*app, options->from);
  app->add_flag("--paused", options->paused, "Start paused");
  app->add_option("--exit-after", options->exit_after, "Close the window after so many seconds")
      ->option_text("S")
      ->check(between(0.0, 1e6));
  app->add_flag("--test-events", options->test_events)->group("");
  add_look(*app, options->look, true);
  add_overlays(*app, options->look);
  add_trail(*app, options->look);
  return {app,
          [options, app] { work(*app, *options); },
          {{"live", "The paper's litter, playing"},
           {"live cold --paused --set pups=24", "A shipped scene with more pups, at its start"}}};
}

}  // namespace pupflow::cli
