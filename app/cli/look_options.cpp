#include "app/cli/look_options.h"

#include <filesystem>

#include "app/cli/parse.h"
#include "app/io/failure.h"
#include "app/view/colormap.h"

namespace pupflow::cli {

void add_look(CLI::App& verb, LookOptions& options) {
  std::string names;
  for (const std::string_view name : view::colormap_names()) {
    names += (names.empty() ? "" : "|") + std::string(name);
  }
  verb.add_option("--colormap", options.colormap, "Colours of body temperature (default viridis)")
      ->option_text(names);
  verb.add_option("--scale", options.scale,
                  "Body temperatures at the ends of the colour scale (default 0,1)")
      ->option_text("MIN,MAX");
  verb.add_option("--supersample", options.supersample,
                  "N x N samples for each pixel, 1 to 8 (default 2)")
      ->option_text("N")
      ->check(CLI::Range(1, 8));
  verb.add_option("--shader-dir", options.shader_dir,
                  "Read the shaders from this folder instead of the built-in ones")
      ->option_text("FOLDER");
  verb.add_flag("--verbose", options.verbose, "Tell which OpenGL context and renderer is used");
}

pictures::Look look_of(const LookOptions& options) {
  const std::vector<double> scale = parse_numbers("--scale", options.scale);
  if (scale.size() != 2 || !(scale[0] < scale[1])) {
    throw io::Failure(io::ExitCode::bad_input,
                      "--scale " + options.scale + ": must be MIN,MAX with MIN < MAX, e.g. 0,1");
  }
  view::find_colormap(options.colormap);  // throws for an unknown name
  std::error_code unreadable;
  if (!options.shader_dir.empty() &&
      !std::filesystem::is_directory(options.shader_dir, unreadable)) {
    throw io::Failure(io::ExitCode::bad_file,
                      "--shader-dir " + options.shader_dir + ": is no folder");
  }
  pictures::Look look;
  look.colormap = options.colormap;
  look.scale_min = scale[0];
  look.scale_max = scale[1];
  look.shader_dir = options.shader_dir;
  look.supersample = options.supersample;
  look.verbose = options.verbose;
  return look;
}

}  // namespace pupflow::cli
