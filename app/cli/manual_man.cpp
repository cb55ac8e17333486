// The manual as pages for man(1).
#include <algorithm>
#include <cctype>

#include "app/cli/manual.h"
#include "app/io/text.h"
#include "pupflow/version.h"

namespace pupflow::cli {
namespace {

/// Text for roff: backslashes and hyphens escaped, and no line that begins with a control sign.
std::string roff(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
    line_begins = c == '\n';
  }
  return out;
}

std::string entries(const std::string& title, const std::vector<Page::Entry>& all) {
  if (all.empty()) return {};
  std::string text = ".SH " + title + "\n";
  for (const Page::Entry& entry : all) {
    text += ".TP\n\\fB" + roff(entry.names) + "\\fR";
    if (!entry.argument.empty()) text += " \\fI" + roff(entry.argument) + "\\fR";
    text += "\n" + roff(entry.text) + "\n";
  }
  return text;
}

}  // namespace

std::string man_page(const Page& page) {
  std::string title = page.name;
  std::replace(title.begin(), title.end(), ' ', '-');
  std::string capitals = title;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text = ".TH " + capitals + " 1 \"\" \"pupflow " + std::string(version_text()) +
                     "\" \"User Commands\"\n";
  text += ".SH NAME\n" + roff(title) + " \\- " + roff(page.summary) + "\n";
  text += ".SH SYNOPSIS\n.B " + roff(page.usage()) + "\n";
  text += entries("VERBS", page.verbs) + entries("ARGUMENTS", page.arguments) +
          entries("OPTIONS", page.options);
  if (!page.remarks.empty()) text += ".SH NOTES\n";
  for (const std::string& remark : page.remarks) text += ".nf\n" + roff(remark) + "\n.fi\n";
  if (!page.examples.empty()) text += ".SH EXAMPLES\n";
  for (const Example& example : page.examples) {
    text += ".TP\n.B pupflow " + roff(example.command) + "\n" + roff(example.does) + "\n";
  }
  text += ".SH EXIT STATUS\n";
  for (const ExitMeaning& exit : exit_meanings()) {
    text += ".TP\n.B " + std::to_string(exit.code) + "\n" + roff(std::string(exit.meaning)) + "\n";
  }
  return text;
}

}  // namespace pupflow::cli
