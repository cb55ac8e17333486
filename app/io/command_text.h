// The command that repeats a run, as it is typed into a shell.
#pragma once

#include <cstdint>
#include <string>

#include "pupflow/parameters.h"

namespace pupflow::io {

/// `word` as a POSIX shell reads it as one word.
std::string shell_word(const std::string& word);

/// "pupflow run SCENE --set ... --at ... --seed N --steps N" for the first `steps` steps of the run
/// of `recipe`, to the bit. `scene` (a path or a shipped name) is named, and only what differs from
/// its parameters `base` said, where that can make the recipe; empty: none.
std::string command_text(const std::string& scene, const Params& base, const Params& recipe,
                         std::int64_t steps);

}  // namespace pupflow::io
