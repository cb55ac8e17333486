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

}  // namespace pupflow::io
