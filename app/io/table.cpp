#include "app/io/table.h"
#include "app/io/text_stream.h"

#include <algorithm>
#include <cmath>

namespace pupflow::io {
namespace {

/// Characters in UTF-8 text: every byte that does not go on with one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

/// `cell` with its bars escaped: a bar ends a cell, even within a code span.
std::string escaped(const std::string& cell) {
  std::string text;
  for (const char c : cell) {
    if (c == '|') text += '\\';
    text += c;
  }
  return text;
}

}  // namespace

std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - width(row[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string markdown_table(const std::vector<Row>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const std::string& cell : rows[i])
      text += "| " + escaped(cell) + (cell.empty() ? "" : " ");
    text += "|\n";
    if (i > 0) continue;
    for (std::size_t column = 0; column < rows[0].size(); ++column) text += "|---";
    text += "|\n";
  }
  return text;
}

std::string bar(double part, double whole) {
  constexpr double kLength = 16;
  if (!(part > 0) || !(whole > 0)) return "";
  const auto cells = static_cast<std::size_t>(std::lround(kLength * std::min(part / whole, 1.0)));
  return cells == 0 ? "." : std::string(cells, '#');
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width_of_lines) {
  std::vector<std::string> lines;
  io::TextStream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || width(lines.back()) + 1 + width(word) > width_of_lines) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

}  // namespace pupflow::io
