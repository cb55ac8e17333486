#include "app/cli/refusals.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/io/nearest.h"
#include "app/io/text.h"
#include "pupflow/parameters.h"

namespace pupflow::cli {
namespace {

/// As they are typed, e.g. "-o", "--csv", "--out"; none of an argument without a name.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// Those of every option.
std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (std::string& name : names_of(*option)) names.push_back(std::move(name));
  }
  return names;
}

bool contains(std::span<const std::string> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::string help_hint(const std::string& command) {
  return "; see '" + command + " --help'";
}

/// The parameter that an unknown option such as --ta names; empty where it names none.
std::string setting_for(const std::string& option) {
  std::string name = option.substr(std::min(option.find_first_not_of('-'), option.size()));
  std::replace(name.begin(), name.end(), '-', '_');
  return find_parameter(name) != nullptr ? name : std::string();
}

constexpr const char* kExtraArguments = "EXTRA";

/// The arguments that are more than the verb takes.
std::vector<std::string> extra_arguments(const CLI::App& app) {
  const CLI::Option* extra = app.get_option_no_throw(kExtraArguments);
  return extra == nullptr ? std::vector<std::string>() : extra->results();
}

/// What stood after an unknown option, which CLI11 may have taken for an argument of the verb.
std::string value_beside(const CLI::App& app, const std::vector<std::string>& options) {
  if (options.size() > 1) return options[1];
  if (const auto arguments = extra_arguments(app); !arguments.empty()) return arguments.front();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() && option->count() > 0) return option->results().front();
  }
  return "...";
}

/// CLI11 calls an option by its first long name; of its names the one among `words`.
std::string as_typed(const std::string& name, const CLI::App& app,
                     std::span<const char* const> words) {
  const CLI::Option* option = name.starts_with('-') ? app.get_option_no_throw(name) : nullptr;
  if (option == nullptr) return name;
  const std::vector<std::string> names = names_of(*option);
  for (const std::string_view word : words) {
    const std::string_view typed = word.substr(0, word.find('='));
    if (contains(names, typed)) return std::string(typed);
  }
  return name;
}

}  // namespace

void refuse_unknown_verb(std::span<const Verb> verbs, std::span<const char* const> words) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs) names.push_back(verb.app->get_name());
  const std::string listed = io::joined(names, ", ");
  if (words.empty()) io::refuse("no verb given: " + listed + "; see 'pupflow --help'");
  const std::string given = words.front();
  if (given.starts_with('-') || contains(names, given)) return;
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string meant = io::did_you_mean(given, views);
  io::refuse("unknown verb " + io::quoted(given) + (meant.empty() ? "; verbs: " + listed : meant));
}

void take_extra_arguments(CLI::App& verb) {
  verb.add_option_function<std::vector<std::string>>(kExtraArguments,
                                                     [](const std::vector<std::string>&) {})
      ->group("");
}

void refuse_extras(const CLI::App& app, const std::string& command) {
  std::vector<std::string> extras = app.remaining();
  const bool behind_dashes = !extras.empty() && extras.front() == "--";
  std::erase(extras, "--");
  const std::vector<std::string> arguments = extra_arguments(app);
  if (extras.empty() && arguments.empty()) return;
  const std::string& first = extras.empty() ? arguments.front() : extras.front();
  if (extras.empty() || behind_dashes || !first.starts_with('-')) {
    io::refuse("unexpected argument " + io::quoted(first) + help_hint(command));
  }
  const std::size_t equals = first.find('=');
  const std::string name = first.substr(0, equals);
  if (const std::string setting = setting_for(name); !setting.empty()) {
    const std::string value =
        equals != std::string::npos ? first.substr(equals + 1) : value_beside(app, extras);
    io::refuse("unknown option " + io::quoted(name) + "; parameters are set with --set " + setting +
               "=" + value);
  }
  const std::vector<std::string> names = names_of(app);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string meant = io::did_you_mean(name, views);
  io::refuse("unknown option " + io::quoted(first) + (meant.empty() ? help_hint(command) : meant));
}

void refuse_taken_options(const CLI::App& app, const std::string& command) {
  const std::vector<std::string> names = names_of(app);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() || option->get_expected_max() == 0) continue;
    for (const std::string& value : option->results()) {
      if (!contains(names, value.substr(0, value.find('=')))) continue;
      io::refuse(option->get_name() + " needs a value, and " + value + " is an option" +
                 help_hint(command));
    }
  }
}

io::Failure bad_command_line(const CLI::ParseError& error, const CLI::App& app,
                             const std::string& command, std::span<const char* const> words) {
  const std::string text = error.what();
  std::string message = text.substr(0, text.find('\n'));
  const std::size_t end = std::min(message.find_first_of(": "), message.size());
  message = as_typed(message.substr(0, end), app, words) + message.substr(end);
  const auto say_instead = [&](const char* of_library, const char* own) {
    const std::size_t at = message.find(of_library);
    if (at != std::string::npos) message = message.substr(0, at) + own;
  };
  say_instead(": 1 required", " needs a value");
  say_instead(": At Most 1 required", " is given twice");
  say_instead(": At most 1 required", " is given twice");
  say_instead(": At Most 2 required", " must be given twice, not more often");
  say_instead(" is required", " must be given");
  say_instead(": At least 2 required", " must be given twice");
  if (const std::size_t at = message.find(" was given a disallowed"); at != std::string::npos) {
    message = "--" + message.substr(0, at) + " takes no value";
  }
  return {io::ExitCode::bad_input, message + help_hint(command)};
}

}  // namespace pupflow::cli
