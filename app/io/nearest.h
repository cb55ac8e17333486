// "Did you mean ...?" for mistyped names.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pupflow::io {

/// The candidate nearest to `name` by edit distance; empty when none differs in less than about a
/// third of its letters.
std::string nearest(std::string_view name, std::span<const std::string_view> candidates);

/// "; did you mean 'X'?" for the nearest candidate, or nothing.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace pupflow::io
