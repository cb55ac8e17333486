#include "app/cli/completion.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/io/scene_file.h"
#include "app/io/text.h"
#include "app/view/overlay.h"
#include "pupflow/fields.h"
#include "pupflow/observer.h"
#include "pupflow/parameters.h"

namespace pupflow::cli {
namespace {

using Words = std::vector<std::string>;

template <class Table>
void add_names(const Table& table, const std::string& ending, Words& words) {
  for (const auto& row : table) words.push_back(std::string(row.name) + ending);
}

Words settings() {
  Words words;
  add_names(parameters(), "=", words);
  return words;
}

Words fields() {
  Words words;
  add_names(pup_fields(), "", words);
  add_names(afferent_fields(), "", words);
  return words;
}

Words statistics() {
  Words words;
  add_names(run_statistics(), "", words);
  return words;
}

Words scenes() {
  Words words;
  add_names(io::shipped_scenes(), "", words);
  return words;
}

Words overlays() {
  Words words;
  add_names(view::overlays(), "", words);
  return words;
}

/// How help writes an argument, and what it may be.
struct ValueKind {
  std::string_view argument;
  Words (*words)();
};
constexpr std::array<ValueKind, 8> kValueKinds{{{"NAME=VALUE", settings},
                                                {"RANGE", settings},
                                                {"FIELD", fields},
                                                {"FIELD,...", fields},
                                                {"STATISTIC", statistics},
                                                {"OVERLAY,...", overlays},
                                                {"SCENE", scenes},
                                                {"NAME", scenes}}};

/// Whether the argument is a choice of words: a|b|c.
bool is_choice(const std::string& argument) {
  return argument.find('|') != std::string::npos &&
         std::none_of(argument.begin(), argument.end(),
                      [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// The words of an option's argument, for the options of a page that have any: their names as a
/// pattern of the shell's `case`, and the words.
std::vector<std::pair<std::string, std::string>> argument_cases(const Page& page) {
  std::vector<std::pair<std::string, std::string>> cases;
  for (const Page::Entry& option : page.options) {
    const Words words = words_for(option.argument);
    if (!words.empty()) {
      cases.emplace_back(io::joined(single_names(option), "|"), io::joined(words, " "));
    }
  }
  return cases;
}

std::string verb_of(const Page& page) {
  return page.name.substr(page.name.find(' ') + 1);
}

std::string option_words(const Page& page) {
  Words words;
  for (const Page::Entry& option : page.options) {
    for (const std::string& name : single_names(option)) words.push_back(name);
  }
  return io::joined(words, " ");
}

std::string first_arguments(const Page& page) {
  Words words;
  for (const Page::Entry& argument : page.arguments) {
    for (const std::string& word : words_for(argument.names)) words.push_back(word);
  }
  return io::joined(words, " ");
}

/// Sets $options, $arguments and, where the word before is an option with known values, $values.
std::string cases_of_verbs(std::span<const Page> verbs) {
  std::string text = "  case $verb in\n";
  for (const Page& page : verbs) {
    text += "    " + verb_of(page) + ")\n      options='" + option_words(page) + "'\n";
    if (const std::string words = first_arguments(page); !words.empty()) {
      text += "      arguments='" + words + "'\n";
    }
    const auto cases = argument_cases(page);
    if (!cases.empty()) text += "      case $before in\n";
    for (const auto& [names, words] : cases) {
      text += "        " + names + ") values='" + words + "' ;;\n";
    }
    if (!cases.empty()) text += "      esac\n";
    text += "      ;;\n";
  }
  return text + "  esac\n";
}

std::string verb_names(const Page& program) {
  Words words;
  for (const Page::Entry& verb : program.verbs) words.push_back(verb.names);
  return io::joined(words, " ") + " " + option_words(program);
}

}  // namespace

std::vector<std::string> words_for(const std::string& argument) {
  for (const ValueKind& kind : kValueKinds) {
    if (kind.argument == argument) return kind.words();
  }
  Words words;
  if (!is_choice(argument)) return words;
  for (const std::string_view word : io::split(argument, '|')) words.emplace_back(word);
  return words;
}

std::vector<std::string> single_names(const Page::Entry& entry) {
  Words names;
  for (const std::string_view part : io::split(entry.names, ',')) {
    names.emplace_back(part.substr(part.find_first_not_of(' ')));
  }
  return names;
}

std::string bash_completion(std::span<const Page> pages) {
  return "# bash completion for pupflow, made by 'pupflow help --format bash'.\n"
         "_pupflow() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local verb=${COMP_WORDS[1]} options='' arguments='' values=''\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" = 1 ]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         verb_names(pages.front()) +
         "' -- \"$word\")\n"
         "    return\n"
         "  fi\n" +
         cases_of_verbs(pages.subspan(1)) +
         "  if [ -n \"$values\" ]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$values\" -- \"$word\")\n"
         "    case ${COMPREPLY[0]-} in *=) compopt -o nospace ;; esac\n"
         "    return\n"
         "  fi\n"
         "  case $word in\n"
         "    -*) mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\") ;;\n"
         "    *)\n"
         "      compopt -o filenames\n"
         "      mapfile -t COMPREPLY < <(compgen -W \"$arguments\" -- \"$word\"; compgen -f -- "
         "\"$word\")\n"
         "      ;;\n"
         "  esac\n"
         "}\n"
         "complete -F _pupflow pupflow\n";
}

std::string zsh_completion(std::span<const Page> pages) {
  return "#compdef pupflow\n"
         "# zsh completion for pupflow, made by 'pupflow help --format zsh'.\n"
         "_pupflow() {\n"
         "  local before=${words[CURRENT-1]} verb=${words[2]} options='' arguments='' values=''\n"
         "  if (( CURRENT == 2 )); then\n"
         "    compadd -- " +
         verb_names(pages.front()) +
         "\n"
         "    return\n"
         "  fi\n" +
         cases_of_verbs(pages.subspan(1)) +
         "  if [[ -n $values ]]; then\n"
         "    if [[ $values == *=* ]]; then compadd -S '' -- ${=values}; else compadd -- "
         "${=values}; fi\n"
         "  elif [[ ${words[CURRENT]} == -* ]]; then\n"
         "    compadd -- ${=options}\n"
         "  else\n"
         "    compadd -- ${=arguments}\n"
         "    _files\n"
         "  fi\n"
         "}\n"
         "_pupflow \"$@\"\n";
}

}  // namespace pupflow::cli
