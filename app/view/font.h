// The typeface that comes inside the program: DejaVu Sans.
#pragma once

#include <cstddef>
#include <span>

namespace pupflow::view {

/// The TrueType file, for any font reader; lives as long as the program.
std::span<const std::byte> font_file();

}  // namespace pupflow::view
