// Scenes: TOML files whose keys are parameter names, beside an optional title, description and
// [[at]] tables, each a change during the run (schedule_text.h).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::io {

struct Scene {
  std::string title;
  std::string description;
  Params params;  // defaults, then what the file sets
};

/// Reads the scene in `text`. Adds one line "NAME:line:column: message" to `problems` for
/// everything wrong with it: TOML that does not parse, an unknown key, a wrong type, a value out of
/// range.
Scene parse_scene(std::string_view text, const std::string& name,
                  std::vector<std::string>& problems);

/// Reads the scene that the user called `scene`: a shipped one (see shipped_scenes), else a file.
/// Adds what is wrong with it to `problems`. Throws Failure: bad_file when the file cannot be read,
/// bad_input when it is neither a path nor a shipped name.
Scene load_scene(const std::string& scene, std::vector<std::string>& problems);

/// A scene that is part of the program; `name` is the file's name without ".toml".
struct ShippedScene {
  std::string_view name;
  std::string_view text;
};

/// Every shipped scene, by name.
std::span<const ShippedScene> shipped_scenes();

}  // namespace pupflow::io
