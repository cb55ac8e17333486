// File names of numbered pictures, such as frames/%05d.png.
#pragma once

#include <cstdint>
#include <string>

namespace pupflow::io {

/// Whether `pattern` holds a place for the number: one %d or %0Nd (N digits, N = 1 ... 9). Throws
/// Failure(bad_input) when it holds any other % or a second one.
bool has_number(const std::string& pattern);

/// `pattern` with its place, if it has one, filled by `number` (not negative), zeros in front.
/// Throws like has_number.
std::string frame_path(const std::string& pattern, std::int64_t number);

}  // namespace pupflow::io
