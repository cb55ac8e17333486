#include "app/cli/look_options.h"

#include <algorithm>
#include <filesystem>

#include "app/cli/parse.h"
#include "app/cli/verb.h"
#include "app/io/named_field.h"
#include "app/io/nearest.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

constexpr const char* kScales = "auto|around-tp|field|MIN,MAX";

/// Sets the ends of `scale` as `text` says.
void take_scale(const std::string& text, view::ColorScale& scale) {
  const auto* name = std::ranges::find(view::kEndsNames, text);
  if (name != view::kEndsNames.end() && !text.empty()) {
    return scale.set_ends(static_cast<view::Ends>(name - view::kEndsNames.begin()));
  }
  const std::string right = "auto, around-tp, field or MIN,MAX with MIN < MAX, e.g. 0,1" +
                            io::did_you_mean(text, view::kEndsNames);
  const std::vector<double> ends = parse_numbers("--scale", text, right);
  if (ends.size() != 2 || !(ends[0] < ends[1])) {
    io::refuse("--scale " + io::quoted(text) + ": must be " + right);
  }
  scale.set_range(ends[0], ends[1]);
}

/// The scale of the field with what was typed for it.
view::ColorScale scale_of(const LookOptions& options) {
  view::ColorScale scale(io::named_field(options.color_by, "--color-by"));
  const auto take = [](const std::string& option, const std::string& text, const auto& set) {
    try {
      set();
    } catch (const io::Failure& failure) {
      const std::string what = failure.what();
      io::refuse(what.starts_with(option) ? what : option + " " + text + ": " + what);
    }
  };
  if (!options.colormap.empty()) {
    take("--colormap", options.colormap, [&] { scale.set_map(options.colormap); });
  }
  if (!options.scale.empty()) {
    take("--scale", options.scale, [&] { take_scale(options.scale, scale); });
  } else if (options.automatic) {
    scale.follow_data();
  }
  return scale;
}

/// The value of an enum whose names are `names`.
template <class Enum, std::size_t N>
Enum named(const std::array<std::string_view, N>& names, const std::string& option,
           std::string_view text) {
  const auto found = std::ranges::find(names, text);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  io::refuse(option + " " + io::quoted(text) + ": must be " + io::joined(names, " or ") +
             io::did_you_mean(text, names));
}

template <std::size_t N>
std::string choices(const std::array<std::string_view, N>& names) {
  return io::joined(names, "|");
}

}  // namespace

void add_look(CLI::App& verb, LookOptions& options, bool automatic) {
  options.automatic = automatic;
  verb.add_option("--color-by", options.color_by,
                  "What the colors show: a field of a pup or of an afferent, e.g. tb, group, "
                  "heading, strain (default " +
                      options.color_by + ")")
      ->option_text("FIELD")
      ->check(not_empty);
  verb.add_option("--colormap", options.colormap,
                  "Colors from low to high (default viridis; bluered for signed fields and around "
                  "T_p, phase for angles)")
      ->option_text(io::joined(view::colormap_names(), "|"))
      ->check(not_empty);
  verb.add_option(
          "--scale", options.scale,
          std::string("Values at the ends of the color scale. auto: the middle 90 % of what "
                      "is seen; around-tp: T_p in the middle; field: the field's range, for "
                      "body temperature 0,1 (default ") +
              (automatic ? "auto" : "field") + ")")
      ->option_text(kScales)
      ->check(not_empty);
  verb.add_option("--draw", options.draw,
                  "Pups as spheres around their points, as a closed skin, or both (default " +
                      options.draw + ")")
      ->option_text(choices(view::kDrawNames));
  verb.add_option("--quality", options.quality,
                  "fast leaves out shadows and soft edges; print takes 3 x 3 samples a pixel "
                  "(default " +
                      options.quality + ")")
      ->option_text(choices(view::kQualityNames));
  verb.add_option("--supersample", options.supersample,
                  "N x N samples for each pixel, 1 to " + std::to_string(pictures::kMostSamples) +
                      " (default: those of the quality)")
      ->option_text("N")
      ->check(between(1, pictures::kMostSamples));
  verb.add_option("--shader-dir", options.shader_dir,
                  "Read the shaders from this folder instead of the built-in ones")
      ->option_text("FOLDER")
      ->check(not_empty);
  verb.add_flag("--verbose", options.verbose, "Tell which OpenGL context and renderer is used");
}

void add_overlays(CLI::App& verb, LookOptions& options) {
  std::string overlays;
  for (const view::Overlay& overlay : view::overlays()) {
    overlays += (overlays.empty() ? "" : "; ") + std::string(overlay.name) + ": " +
                std::string(overlay.doc);
  }
  verb.add_option("--overlay", options.overlay,
                  "What to draw over the litter, joined by commas. " + overlays)
      ->option_text("OVERLAY,...")
      ->check(not_empty);
  verb.add_flag("--caption", options.caption, "Write into the picture what it shows");
}

void add_trail(CLI::App& verb, LookOptions& options) {
  verb.add_option("--trail", options.trail,
                  "Length of the overlay's trails in seconds of the model (default " +
                      io::number_text(options.trail) + ")")
      ->option_text("S")
      ->check(between(0.01, pictures::kLongestTrail));
}

void add_picture_look(CLI::App& verb, LookOptions& options) {
  add_overlays(verb, options);
  verb.add_flag("--celsius", options.celsius,
                "Temperatures in degrees, too: beside the legend of the colors, in titles and "
                "the caption; 0.6 is 37 °C");
  verb.add_flag("--transparent", options.transparent, "Leave out the paper behind the scene");
  verb.add_option("--dpi", options.dpi, "Dots per inch that the file names")
      ->option_text("N")
      ->check(between(1, pictures::kMostDpi));
}

const std::string* find_entry(const io::TextEntries& entries, std::string_view key) {
  const auto found = std::ranges::find(entries, key, &io::TextEntries::value_type::first);
  return found == entries.end() ? nullptr : &found->second;
}

void take_look(const CLI::App& verb, const io::TextEntries& picture, LookOptions& options) {
  const auto take = [&](const char* key, const char* option, auto& value) {
    const std::string* entry = find_entry(picture, key);
    const CLI::Option* declared = verb.get_option_no_throw(option);
    if (entry == nullptr || (declared != nullptr && declared->count() > 0)) return;
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::string>) {
      value = *entry;
    } else if constexpr (std::is_same_v<Value, bool>) {
      value = *entry == "true";
    } else {
      value = io::read_number<Value>(*entry).value_or(value);
    }
  };
  // The scale of one field says nothing about another, nor samples about another quality.
  if (verb.count("--color-by") == 0) {
    take("colormap", "--colormap", options.colormap);
    take("scale", "--scale", options.scale);
  }
  if (verb.count("--quality") == 0) take("supersample", "--supersample", options.supersample);
  take("color_by", "--color-by", options.color_by);
  take("draw", "--draw", options.draw);
  take("quality", "--quality", options.quality);
  take("overlay", "--overlay", options.overlay);
  take("trail", "--trail", options.trail);
  take("caption", "--caption", options.caption);
  take("celsius", "--celsius", options.celsius);
  take("transparent", "--transparent", options.transparent);
  take("dpi", "--dpi", options.dpi);
}

io::Failure about_like(const CLI::App& verb, const std::string& like, const io::Failure& failure) {
  struct Taken {
    std::string option, key;
  };
  std::string message = failure.what();
  if (message.starts_with("camera '")) message = "--" + message;
  for (const auto& [option, key] : {Taken{"--size", "size"},
                                    {"--camera", "camera"},
                                    {"--target", "camera_target"},
                                    {"--grid", "grid"},
                                    {"--at", "step"},
                                    {"--ta", "panels_ta"},
                                    {"--color-by", "color_by"},
                                    {"--colormap", "colormap"},
                                    {"--scale", "scale"},
                                    {"--draw", "draw"},
                                    {"--quality", "quality"},
                                    {"--overlay", "overlay"}}) {
    const std::string rest = message.substr(std::min(option.size(), message.size()));
    if (!message.starts_with(option) || (!rest.starts_with(' ') && !rest.starts_with(':')))
      continue;
    const CLI::Option* declared = verb.get_option_no_throw(option);
    if (like.empty() || failure.several() || (declared && declared->count() > 0)) break;
    return {failure.code(), like + ": " + key + rest};
  }
  return failure;
}

void check_picture_name(const std::string& option, const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending.empty() || ending == ".png" || ending == ".PNG") return;
  io::refuse(option + " " + io::quoted(path) + ": pictures are PNG; the name must end in .png");
}

pictures::Look look_of(const LookOptions& options) {
  std::error_code unreadable;
  if (!options.shader_dir.empty() &&
      !std::filesystem::is_directory(options.shader_dir, unreadable)) {
    throw io::Failure(io::ExitCode::bad_file,
                      "--shader-dir " + options.shader_dir + ": is no folder");
  }
  pictures::Look look;
  look.scale = scale_of(options);
  look.draw = named<view::Draw>(view::kDrawNames, "--draw", options.draw);
  look.quality = named<view::Quality>(view::kQualityNames, "--quality", options.quality);
  look.trail = options.trail;
  look.caption = options.caption;
  look.celsius = options.celsius;
  look.transparent = options.transparent;
  look.dpi = options.dpi;
  look.shader_dir = options.shader_dir;
  look.supersample = options.supersample;
  look.verbose = options.verbose;
  if (look.dpi < 0 || look.dpi > pictures::kMostDpi || !(look.trail > 0) ||
      look.trail > pictures::kLongestTrail) {
    io::refuse("the picture of --like names no sound dpi or trail");
  }
  try {
    look.overlays = view::OverlaySet::parse(options.overlay);
  } catch (const io::Failure& failure) {
    io::refuse("--overlay " + options.overlay + ": " + failure.what());
  }
  return look;
}

}  // namespace pupflow::cli
