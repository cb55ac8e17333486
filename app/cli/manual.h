// The manual: what the program's options and examples say, as help, man page, page of the docs and
// completion of shells. All are made from the verbs as they are declared.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/cli/verb.h"

namespace pupflow::cli {

/// One page: a verb, or the program itself.
struct Page {
  struct Entry {
    std::string names;     // "-o, --out"; of an argument or a verb its name
    std::string argument;  // what follows it, e.g. "FILE"; empty where nothing does
    std::string text;
    bool required = false, many = false;  // of arguments
  };

  std::string name;  // as typed: "pupflow run"
  std::string summary;
  std::vector<Entry> verbs, arguments, options;
  std::vector<std::string> remarks;  // a paragraph each; line ends stand
  std::vector<Example> examples;

  /// "pupflow run [OPTIONS] [SCENE]".
  std::string usage() const;
};

Page page_of(const Verb& verb);

/// The page of the program, which lists the verbs.
Page page_of(const CLI::App& program, std::span<const Verb> verbs);

/// An exit code and what it means.
struct ExitMeaning {
  int code;
  std::string_view meaning;
};
std::span<const ExitMeaning> exit_meanings();

/// A form of the manual. `one` writes a page; `all` writes something made from all pages, the
/// program's first, and is null where each page is a text of its own.
struct ManualForm {
  std::string_view name;
  std::string_view doc;
  std::string (*one)(const Page& page);
  std::string (*all)(std::span<const Page> pages);
};

/// Every form, the one of --help first.
std::span<const ManualForm> manual_forms();

// The forms, each in a file of its own.
std::string help_text(const Page& page);  // at most 80 columns
std::string markdown_page(const Page& page);
std::string man_page(const Page& page);
std::string bash_completion(std::span<const Page> pages);
std::string zsh_completion(std::span<const Page> pages);

}  // namespace pupflow::cli
