// Aligned columns of text.
#pragma once

#include <string>
#include <vector>

namespace pupflow::io {

using Row = std::vector<std::string>;

/// The rows as lines, each column as wide as its widest cell (counted in characters, UTF-8) and two
/// blanks apart. A row may be short; nothing follows a row's last cell.
std::string aligned(const std::vector<Row>& rows);

/// The rows as a Markdown table; the first is its head, and all are as long.
std::string markdown_table(const std::vector<Row>& rows);

/// A bar of '#' for a part of a whole, 16 of them for all of it; '.' for a part too small for one.
/// Empty where there is no part or no whole.
std::string bar(double part, double whole);

/// `text` in lines of at most `width` characters, broken between words; a longer word stays whole.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace pupflow::io
