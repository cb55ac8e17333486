#include "app/cli/manual.h"

#include <algorithm>
#include <array>

#include "app/io/failure.h"

namespace pupflow::cli {
namespace {

using io::ExitCode;

constexpr std::array kExits{
    ExitMeaning{static_cast<int>(ExitCode::done), "done"},
    ExitMeaning{static_cast<int>(ExitCode::difference), "verify or compare found a difference"},
    ExitMeaning{static_cast<int>(ExitCode::bad_input), "the input is wrong"},
    ExitMeaning{static_cast<int>(ExitCode::bad_numbers),
                "the numbers went wrong; what was written before is kept"},
    ExitMeaning{static_cast<int>(ExitCode::bad_file), "a file could not be read or written"},
    ExitMeaning{static_cast<int>(ExitCode::no_context), "no OpenGL context could be made"},
    ExitMeaning{static_cast<int>(ExitCode::interrupted), "interrupted; what was done is kept"},
};

template <bool pages_of_their_own>
constexpr ManualForm form(std::string_view name, std::string_view doc, auto write) {
  if constexpr (pages_of_their_own) {
    return {name, doc, write, nullptr};
  } else {
    return {name, doc, nullptr, write};
  }
}

constexpr std::array kForms{
    form<true>("text", "what --help prints", help_text),
    form<true>("markdown", "a page of the docs", markdown_page),
    form<true>("man", "a page for man(1)", man_page),
    form<false>("bash", "completion for bash", bash_completion),
    form<false>("zsh", "completion for zsh", zsh_completion),
};

std::string joined_names(const CLI::Option& option) {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  return names;
}

Page::Entry entry_of(const CLI::Option& option) {
  Page::Entry entry;
  entry.text = option.get_description();
  if (option.get_positional()) {
    entry.names = option.get_name(true);
    entry.required = option.get_required();
    entry.many = option.get_expected_max() > 1;
    return entry;
  }
  entry.names = joined_names(option);
  if (option.get_option_text() != " ") entry.argument = option.get_option_text();
  return entry;
}

void add_options(const CLI::App& app, Page& page) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    (option->get_positional() ? page.arguments : page.options).push_back(entry_of(*option));
  }
  if (const std::string footer = app.get_footer(); !footer.empty()) page.remarks.push_back(footer);
}

}  // namespace

std::string Page::usage() const {
  std::string text = name;
  if (!verbs.empty()) return text + " VERB [OPTIONS]";
  if (!options.empty()) text += " [OPTIONS]";
  for (const Entry& argument : arguments) {
    const std::string word = argument.names + (argument.many ? "..." : "");
    text += " " + (argument.required ? word : "[" + word + "]");
  }
  return text;
}

Page page_of(const Verb& verb) {
  Page page;
  page.name = "pupflow " + verb.app->get_name();
  page.summary = verb.app->get_description();
  add_options(*verb.app, page);
  page.examples = verb.examples;
  return page;
}

Page page_of(const CLI::App& program, std::span<const Verb> verbs) {
  Page page;
  page.name = "pupflow";
  page.summary = program.get_description();
  for (const Verb& verb : verbs) {
    page.verbs.push_back({verb.app->get_name(), "", verb.app->get_description()});
  }
  add_options(program, page);
  page.examples = {{"live", "Open the window"},
                   {"run cold --csv cold.csv", "Step a shipped scene, a row a step"}};
  return page;
}

std::span<const ExitMeaning> exit_meanings() {
  return kExits;
}

std::span<const ManualForm> manual_forms() {
  return kForms;
}

}  // namespace pupflow::cli
