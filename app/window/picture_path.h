// Where pictures and films of the window go.
#pragma once

#include <cstdint>
#include <string>

namespace pupflow::window {

/// Where the next picture goes: `pattern` (with %d or %05d for the step; empty: pupflow-%05d.png)
/// with the step filled in, and -2, -3 ... added before the ending until no such file exists.
/// Throws Failure(bad_input) for a bad pattern.
std::string picture_path(const std::string& pattern, std::int64_t step);

}  // namespace pupflow::window
