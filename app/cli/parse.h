// Option values that are more than one number. All throw io::Failure(bad_input), naming `option`.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pupflow::cli {

/// "1280x960": width and height in pixels, within pictures::kSmallestSide ... kLargestSide.
std::pair<int, int> parse_size(const std::string& option, const std::string& text);

/// Width and height as they are typed.
std::string size_text(int width, int height);

/// Finite numbers joined by commas, at least one. The message says that the value must be `right`.
std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  const std::string& right);

/// Step numbers (whole, not negative) joined by commas; sorted, without repeats.
std::vector<std::int64_t> parse_steps(const std::string& option, const std::string& text);

}  // namespace pupflow::cli
