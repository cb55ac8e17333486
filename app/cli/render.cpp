// pupflow render: headless PNG frames of one scene, a film of it, or a sheet of several.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "app/cli/graphics_module.h"
#include "app/cli/grid.h"
#include "app/cli/look_options.h"
#include "app/cli/parse.h"
#include "app/cli/start.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/celsius.h"
#include "app/io/failure.h"
#include "app/io/frame_path.h"
#include "app/io/movie.h"
#include "app/io/params_of_file.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

using io::ExitCode;
using io::Failure;

constexpr std::int64_t kMostFrames = 1'000'000;
constexpr double kFurthestTarget = 1e6;
constexpr int kUsualFps = 25;
constexpr const char* kUsualSheet = "grid.png";
constexpr const char* kOfCelsius = "a temperature: colors of one with their legend, or --caption";

struct RenderOptions {
  Common common;
  LookOptions look;
  std::string from;
  std::int64_t every = 0;
  std::string size = size_text(pictures::RenderJob{}.width, pictures::RenderJob{}.height);
  std::string camera = view::Camera::kUsual;
  std::string target;
  std::optional<int> follow;
  bool no_bar = false;
  std::string movie;
  std::optional<int> fps;
  std::vector<std::string> grid;
  int panel = pictures::SheetJob{}.panel;
};

/// --at names frames by their steps, or changes as it does everywhere: takes the former away from
/// `at` and returns them joined.
std::string take_frames(std::vector<std::string>& at) {
  std::string frames;
  std::erase_if(at, [&](const std::string& text) {
    if (text.find('=') != std::string::npos) return false;
    if (text.empty()) parse_steps("--at", text);  // refuses it
    frames += (frames.empty() ? "" : ",") + text;
    return true;
  });
  return frames;
}

/// The steps between two frames: those of --every, or for a film so many that a second of it is a
/// second of the model. 0: one frame, after the last step.
std::int64_t frame_distance(const RenderOptions& options, const Params& params) {
  if (options.every != 0 || options.movie.empty()) return options.every;
  const double steps = 1 / (options.fps.value_or(kUsualFps) * params.dt);
  return static_cast<std::int64_t>(std::clamp(std::round(steps), 1.0, 1e15));
}

/// Whether the length of the run was typed.
bool says_steps(const io::Settings& settings) {
  return settings.steps || std::ranges::any_of(settings.sets, [](const std::string& set) {
           return set.starts_with("steps=");
         });
}

/// The steps after which a frame is wanted, of a run that begins after step `begin`.
std::vector<std::int64_t> frame_steps(const RenderOptions& options, const std::string& at,
                                      const Params& params, std::int64_t begin) {
  if (!at.empty()) {
    if (options.every != 0) io::refuse("--at STEPS and --every both say which frames; use one");
    const std::vector<std::int64_t> steps = parse_steps("--at", at);
    if (says_steps(options.common.settings) && steps.back() > params.steps) {
      io::refuse("--at " + at + ": the run ends after step " + std::to_string(params.steps) +
                 "; leave out --steps, or give at least " + std::to_string(steps.back()));
    }
    return steps;
  }
  const std::int64_t every = frame_distance(options, params);
  if (every == 0) return {params.steps};
  const std::int64_t count = params.steps / every - begin / every;
  if (count <= 0 || count > kMostFrames) {
    const bool typed = options.every != 0;
    io::refuse((typed ? "--every " : "--movie " + options.movie + ": a frame every ") +
               std::to_string(every) + (typed ? ": gives " : " steps gives ") +
               std::to_string(std::max<std::int64_t>(count, 0)) + " frames over " +
               std::to_string(params.steps - begin) + " steps; must be 1 to " +
               std::to_string(kMostFrames) + (typed ? "" : "; see --every and --steps"));
  }
  std::vector<std::int64_t> steps;
  for (std::int64_t i = 1; i <= count; ++i) steps.push_back((begin / every + i) * every);
  return steps;
}

/// Refuses one name for several frames.
void check_pattern(const std::string& pattern, std::size_t frames) {
  if (io::has_number(pattern) || frames == 1) return;
  throw Failure(ExitCode::bad_input,
                "--out " + pattern + ": " + std::to_string(frames) +
                    " frames need a place for the step, e.g. --out 'frames/%05d.png'");
}

/// Takes what was not typed from the picture of --like: its look, its camera, its panels, its step.
void take_picture(const CLI::App& verb, RenderOptions& options, std::string& frames) {
  const std::string& like = options.common.settings.like;
  if (like.empty()) return;
  const io::TextEntries picture = io::entries_of_file(like);
  if (find_entry(picture, "camera") == nullptr) return;  // of no single scene
  take_look(verb, picture, options.look);
  const auto take = [&](const char* key, const char* option, std::string& value) {
    const std::string* entry = find_entry(picture, key);
    if (entry != nullptr && verb.count(option) == 0) value = *entry;
  };
  take("size", "--size", options.size);
  take("camera", "--camera", options.camera);
  if (verb.count("--camera") == 0 && !options.follow) {
    take("camera_target", "--target", options.target);
  }
  const std::string* bar = find_entry(picture, "bar");
  if (bar != nullptr && *bar == "false") options.no_bar = true;
  if (const std::string* grid = find_entry(picture, "grid"); grid && options.grid.empty()) {
    for (const std::string_view axis : io::split(*grid, ' ')) options.grid.emplace_back(axis);
  }
  if (const std::string* panel = find_entry(picture, "panel");
      panel && verb.count("--panel") == 0) {
    options.panel = io::read_number<int>(*panel).value_or(options.panel);
  }
  const std::string* step = find_entry(picture, "step");
  if (step != nullptr && frames.empty() && options.every == 0 && options.movie.empty() &&
      options.grid.empty() && verb.count("--steps") == 0) {
    frames = *step;
  }
}

view::Camera camera_of(const RenderOptions& options) {
  view::Camera camera = view::Camera::parse(options.camera);
  if (options.target.empty()) return camera;
  if (options.follow) io::refuse("--target and --follow both say what is in the middle; use one");
  const std::string right = "X,Y,Z in arena units, each within +-1e6, e.g. 0.5,0,0.3";
  const std::vector<double> place = parse_numbers("--target", options.target, right);
  const auto far = [](double number) { return std::abs(number) > kFurthestTarget; };
  if (place.size() != 3 || std::ranges::any_of(place, far)) {
    io::refuse("--target " + io::quoted(options.target) + ": must be " + right);
  }
  camera.look_at({place[0], place[1], place[2]});
  return camera;
}

/// A film whose frames were kept, for want of ffmpeg, has said so already.
void say_written(const pictures::RenderJob& job) {
  if (job.output.quiet) return;
  if (job.fps > 0) {
    std::error_code gone;
    if (std::filesystem::exists(job.output.path, gone))
      io::print("wrote " + job.output.path + "\n");
    return;
  }
  const std::string first = io::frame_path(job.output.path, job.at.front());
  const std::string last = io::frame_path(job.output.path, job.at.back());
  io::print(first == last ? "wrote " + first + "\n"
                          : "wrote " + std::to_string(job.at.size()) + " pictures, " + first +
                                " to " + last + "\n");
}

/// The file that is written, and for a film its frames a second.
void take_output(const CLI::App& verb, const RenderOptions& options, pictures::RenderJob& job) {
  job.output = {options.common.out, options.common.force, options.common.quiet};
  if (options.movie.empty()) {
    refuse_idle(verb, "--fps", false, "--movie FILE");
    check_picture_name("--out", job.output.path);
    return check_pattern(job.output.path, job.at.size());
  }
  if (verb.count("--out") > 0) {
    io::refuse("--out names pictures, --movie a film; use one");
  }
  job.output.path = options.movie;
  job.fps = options.fps.value_or(kUsualFps);
  io::check_movie(options.movie, job.fps, job.width, job.height);
}

/// Draws the panels of --grid.
void draw_sheet(const CLI::App& verb, const RenderOptions& options, const io::Settings& settings,
                const std::string& frames) {
  for (const char* option :
       {"--movie", "--fps", "--from", "--every", "--size", "--follow", "--trail"}) {
    if (verb.count(option) == 0) continue;
    io::refuse(std::string(option) + ": does not go with " +
               (verb.count("--grid") > 0 ? "--grid" : "the panels of --like"));
  }
  if (!frames.empty()) {
    io::refuse("--at " + frames + ": panels show the last step; use --steps");
  }
  pictures::SheetJob job;
  job.verb = "render --grid";
  job.axes = parse_grid(options.grid);
  for (const pictures::Axis& axis : job.axes) {
    for (const std::string& set : settings.sets) {
      if (set.starts_with(axis.parameter + "=")) {
        io::refuse("--set " + set + ": each panel has its own " + axis.parameter);
      }
    }
  }
  job.params = start_of(settings, "").recipe;
  job.panel = options.panel;
  job.camera = camera_of(options);
  job.bar = !options.no_bar;
  job.threads = thread_count(options.common);
  job.look = look_of(options.look);
  const bool titled = std::ranges::any_of(job.axes, [](const pictures::Axis& axis) {
    return io::is_temperature(*find_parameter(axis.parameter));
  });
  refuse_idle(verb, "--celsius",
              titled || job.look.caption || (job.bar && job.look.scale.is_temperature()),
              kOfCelsius);
  job.output = {verb.count("--out") > 0 ? options.common.out : kUsualSheet, options.common.force,
                options.common.quiet};
  check_picture_name("--out", job.output.path);
  if (io::has_number(job.output.path)) {
    io::refuse("--out " + job.output.path + ": a sheet is one picture; name it without %");
  }
  job.entries = {{"picture", "grid"}};
  io::refuse_existing(job.output.path, job.output.force);
  load_graphics().sheet(job);
  if (!job.output.quiet) io::print("wrote " + job.output.path + "\n");
}

void work(const CLI::App& verb, RenderOptions options) {
  io::Settings settings = options.common.settings;
  std::string frames = take_frames(settings.at);
  take_picture(verb, options, frames);
  if (!options.grid.empty()) return draw_sheet(verb, options, settings, frames);
  refuse_idle(verb, "--panel", false, "--grid RANGE");
  pictures::RenderJob job;
  const Start start = start_of(settings, options.from);
  job.params = start.recipe;
  job.from = start.from;
  job.at = frame_steps(options, frames, job.params, job.from ? job.from->step : 0);
  std::tie(job.width, job.height) = parse_size("--size", options.size);
  job.camera = camera_of(options);
  job.follow = options.follow;
  job.threads = thread_count(options.common);
  job.bar = !options.no_bar;
  job.look = look_of(options.look);
  refuse_idle(verb, "--trail", job.look.overlays.has("trails"), "--overlay trails");
  refuse_idle(verb, "--celsius", job.look.caption || (job.bar && job.look.scale.is_temperature()),
              kOfCelsius);
  refuse_idle(verb, "--dpi", options.movie.empty(), "a picture; a film names no dots per inch");
  take_output(verb, options, job);
  load_graphics().render(job);
  say_written(job);
}

}  // namespace

Verb add_render(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "render", "Draw a scene as PNG frames or a film; needs no display and no GPU");
  const auto options = std::make_shared<RenderOptions>();
  options->common.out = "frames/%05d.png";
  CommonHelp help;
  help.threads = "Threads that share a step (default: all cores, where the litter is large enough)";
  help.out =
      "The picture's file; with %d or %0Nd for the step its folder is made where missing (default "
      "frames/%05d.png)";
  help.at = "draw a frame after each of these steps, e.g. 500,1500 (0 is the start)";
  help.quiet = "No progress";
  add_common(*app, options->common, help);
  app->add_option(
         "--every", options->every,
         "A frame after steps N, 2N, ... up to --steps. Without it and --at STEPS a picture "
         "shows the last step, and a second of a film is a second of the model")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  add_from(*app, options->from);
  app->add_option("--movie", options->movie,
                  "Write a film in place of pictures, " + io::movie_endings() +
                      "; needs ffmpeg, without which its frames go to the folder FILE_frames")
      ->option_text("FILE")
      ->check(not_empty);
  app->add_option("--fps", options->fps,
                  "Frames a second of the film, 1 to " + std::to_string(io::kMostFps) +
                      "; a GIF has at most 50 (default " + std::to_string(kUsualFps) + ")")
      ->option_text("N")
      ->check(between(1, io::kMostFps));
  app->add_option(
         "--grid", options->grid,
         "Panels of one picture: a parameter's values, name=a,b,c, name=from:to:count or "
         "name=from..to for whole numbers; give it twice for a table of two. One scale for "
         "all; --out is " +
             std::string(kUsualSheet) + " unless given")
      ->option_text("RANGE")
      ->allow_extra_args(false)
      ->take_all()
      ->check(not_empty);
  app->add_option("--panel", options->panel,
                  "Edge of a panel of --grid in pixels, " +
                      std::to_string(pictures::kSmallestPanel) + " to " +
                      std::to_string(pictures::kLargestPanel) + " (default " +
                      std::to_string(options->panel) + ")")
      ->option_text("N")
      ->check(between(pictures::kSmallestPanel, pictures::kLargestPanel));
  app->add_option("--size", options->size, "Pixels (default " + options->size + ")")
      ->option_text("WxH");
  app->add_option(
         "--camera", options->camera,
         "top, side, or orbit:azimuth,elevation[,distance[,view]] in degrees and arena units "
         "(default " +
             options->camera + ")")
      ->option_text("CAMERA");
  app->add_option(
         "--target", options->target,
         "The place in the middle of the picture, in arena units (default: where the arena "
         "fills it)")
      ->option_text("X,Y,Z")
      ->check(not_empty);
  app->add_option("--follow", options->follow, "Keep this pup in the middle of the picture")
      ->option_text("PUP")
      ->check(between(0, std::numeric_limits<int>::max()));
  app->add_flag("--no-bar", options->no_bar, "Leave out the legend of the colors");
  add_look(*app, options->look, true);
  add_picture_look(*app, options->look);
  add_trail(*app, options->look);
  return {app,
          [options, app] {
            try {
              work(*app, *options);
            } catch (const Failure& failure) {
              throw about_like(*app, options->common.settings.like, failure);
            }
          },
          {{"render cold --at 500,1500 --out 'cold-%05d.png'", "Pictures after steps 500 and 1500"},
           {"render critical --movie critical.mp4", "A film of the whole run"}}};
}

}  // namespace pupflow::cli
