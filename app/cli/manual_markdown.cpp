// The manual as pages of the docs.
#include "app/cli/manual.h"
#include "app/io/table.h"

namespace pupflow::cli {
namespace {

/// Text for a cell of a table.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string code(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return "`" + text + "`";
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
  for (const std::string& remark : page.remarks) text += remark + "\n\n";
  if (!page.examples.empty()) text += "## Examples\n\n";
  for (const Example& example : page.examples) {
    text += example.does + ":\n\n    pupflow " + example.command + "\n\n";
  }
  return text + exit_codes();
}

}  // namespace pupflow::cli
