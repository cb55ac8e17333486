#include "app/cli/look_options.h"

#include <filesystem>

#include "app/cli/parse.h"
#include "app/cli/verb.h"
#include "app/io/failure.h"
#include "app/io/named_field.h"

namespace pupflow::cli {
namespace {

/// The scale of the field with what was typed for it.
view::ColorScale scale_of(const LookOptions& options) {
  view::ColorScale scale(io::named_field(options.color_by, "--color-by"));
  const auto take = [](const std::string& option, const std::string& text, const auto& set) {
    try {
      set();
    } catch (const io::Failure& failure) {
      io::refuse(option + " " + text + ": " + failure.what());
    }
  };
  if (!options.colormap.empty()) {
    take("--colormap", options.colormap, [&] { scale.set_map(options.colormap); });
  }
  if (options.scale.empty()) return scale;
  const std::vector<double> ends = parse_numbers("--scale", options.scale);
  if (ends.size() != 2 || !(ends[0] < ends[1])) {
    io::refuse("--scale " + options.scale + ": must be MIN,MAX with MIN < MAX, e.g. 0,1");
  }
  take("--scale", options.scale, [&] { scale.set_range(ends[0], ends[1]); });
  return scale;
}

}  // namespace

void add_look(CLI::App& verb, LookOptions& options) {
  std::string names;
  for (const std::string_view name : view::colormap_names()) {
    names += (names.empty() ? "" : "|") + std::string(name);
  }
  verb.add_option("--color-by", options.color_by,
                  "What the colors show: a field of a pup or of an afferent, e.g. tb, group, "
                  "heading, strain (default " +
                      options.color_by + ")")
      ->option_text("FIELD")
      ->check(not_empty);
  verb.add_option("--colormap", options.colormap,
                  "Colors from low to high (default viridis; bluered for signed fields, phase for "
                  "angles)")
      ->option_text(names)
      ->check(not_empty);
  verb.add_option("--scale", options.scale,
                  "Values at the ends of the color scale (default the field's range; for body "
                  "temperature 0,1)")
      ->option_text("MIN,MAX")
      ->check(not_empty);
  verb.add_option("--supersample", options.supersample,
                  "N x N samples for each pixel, 1 to " + std::to_string(pictures::kMostSamples) +
                      " (default " + std::to_string(options.supersample) + ")")
      ->option_text("N")
      ->check(CLI::Range(1, pictures::kMostSamples));
  verb.add_option("--shader-dir", options.shader_dir,
                  "Read the shaders from this folder instead of the built-in ones")
      ->option_text("FOLDER");
  verb.add_flag("--verbose", options.verbose, "Tell which OpenGL context and renderer is used");
}

pictures::Look look_of(const LookOptions& options) {
  std::error_code unreadable;
  if (!options.shader_dir.empty() &&
      !std::filesystem::is_directory(options.shader_dir, unreadable)) {
    throw io::Failure(io::ExitCode::bad_file,
                      "--shader-dir " + options.shader_dir + ": is no folder");
  }
  return {.scale = scale_of(options),
          .shader_dir = options.shader_dir,
          .supersample = options.supersample,
          .verbose = options.verbose};
}

}  // namespace pupflow::cli
