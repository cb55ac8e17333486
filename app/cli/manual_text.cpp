// The manual as --help prints it.
#include <algorithm>
#include <string_view>

#include "app/cli/manual.h"
#include "app/io/table.h"
#include "app/io/text.h"

namespace pupflow::cli {
namespace {

constexpr std::size_t kWidth = 80, kIndent = 2, kColumn = 26;

/// `text` in lines of at most kWidth, each but the first after `indent` blanks. Line ends stand,
/// and so do the blanks after them.
std::string indented(std::string_view text, std::size_t indent) {
  std::string out;
  for (const std::string_view line : io::split(text, '\n')) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    const std::string margin(indent + blanks, ' ');
    for (const std::string& part : io::wrapped(std::string(line), kWidth - margin.size())) {
      out += (out.empty() ? margin.substr(indent) : '\n' + margin) + part;
    }
    if (line.empty()) out += '\n';
  }
  return out;
}

std::string entry_text(const Page::Entry& entry) {
  std::string head = std::string(kIndent, ' ') + entry.names;
  if (!entry.argument.empty()) head += ' ' + entry.argument;
  const bool fits = head.size() + 2 <= kColumn;
  head += fits ? std::string(kColumn - head.size(), ' ') : '\n' + std::string(kColumn, ' ');
  return head + indented(entry.text, kColumn) + '\n';
}

std::string section(const std::string& title, const std::vector<Page::Entry>& entries) {
  if (entries.empty()) return {};
  std::string text = '\n' + title + ":\n";
  for (const Page::Entry& entry : entries) text += entry_text(entry);
  return text;
}

}  // namespace

std::string help_text(const Page& page) {
  std::string text = indented(page.summary, 0) + "\n\nUsage: " + page.usage() + '\n';
  text += section("Verbs", page.verbs) + section("Arguments", page.arguments) +
          section("Options", page.options);
  for (const std::string& remark : page.remarks) {
    const std::size_t end = remark.find_last_not_of('\n') + 1;
    text += '\n' + indented(std::string_view(remark).substr(0, end), 0) + '\n';
  }
  if (!page.examples.empty()) text += "\nExamples:\n";
  for (const Example& example : page.examples) {
    text += "  pupflow " + example.command + "\n      " + indented(example.does, 6) + '\n';
  }
  text += "\nExit codes:\n";
  for (const ExitMeaning& exit : exit_meanings()) {
    text += io::formatted("  %-5d", exit.code) + std::string(exit.meaning) + '\n';
  }
  return text;
}

}  // namespace pupflow::cli
