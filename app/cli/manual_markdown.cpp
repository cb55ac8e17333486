// The manual as pages of the docs.
#include "app/cli/manual.h"
#include "app/io/table.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

/// Text for a cell of a table.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<' || c == '*') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string code(const std::string& text) {
  return "`" + text + "`";
}

/// A remark; its indented lines are a list.
std::string paragraph(const std::string& remark) {
  std::string text;
  bool in_list = false;
  for (const std::string_view line : io::split(remark, '\n')) {
    if (line.empty()) continue;
    const bool item = line.starts_with("  ");
    if (item && !in_list) text += '\n';
    text += item ? "- " + std::string(line.substr(2)) : std::string(line);
    text += '\n';
    in_list = item;
  }
  return text + '\n';
}

std::string table(const std::string& title, const std::string& column,
                  const std::vector<Page::Entry>& entries) {
  if (entries.empty()) return {};
  std::vector<io::Row> rows{{column, "meaning"}};
  for (const Page::Entry& entry : entries) {
    rows.push_back({code(entry.names + (entry.argument.empty() ? "" : ' ' + entry.argument)),
                    cell(entry.text)});
  }
  return "## " + title + "\n\n" + io::markdown_table(rows) + '\n';
}

std::string exit_codes() {
  std::vector<io::Row> rows{{"code", "meaning"}};
  for (const ExitMeaning& exit : exit_meanings()) {
    rows.push_back({std::to_string(exit.code), std::string(exit.meaning)});
  }
  return "## Exit codes\n\n" + io::markdown_table(rows);
}

}  // namespace

std::string markdown_page(const Page& page) {
  std::string text = "# " + page.name + "\n\n" + page.summary + "\n\n    " + page.usage() + "\n\n";
  text += table("Verbs", "verb", page.verbs) + table("Arguments", "argument", page.arguments) +
          table("Options", "option", page.options);
  for (const std::string& remark : page.remarks) text += paragraph(remark);
  if (!page.examples.empty()) text += "## Examples\n\n";
  for (const Example& example : page.examples) {
    text += example.does + ":\n\n    pupflow " + example.command + "\n\n";
  }
  return text + exit_codes();
}

}  // namespace pupflow::cli
