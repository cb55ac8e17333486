// Writes scenes in the form that scene_file.h reads.
#pragma once

#include <string>

#include "app/io/scene_file.h"

namespace pupflow::io {

/// The scene as a TOML file: title and description, each parameter whose value is not the default,
/// and the seed, then an [[at]] table for each change. `parse_scene` reads the same scene from it,
/// to the bit. Text that is no UTF-8 is written as `printable` shows it.
std::string scene_text(const Scene& scene);

}  // namespace pupflow::io
