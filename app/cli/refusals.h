// Command lines that are refused before a verb works, in words that say what would be right. All
// throw io::Failure(bad_input).
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "app/cli/verb.h"
#include "app/io/failure.h"

namespace pupflow::cli {

/// Refuses `words`, those after the program's name, that do not begin with a verb or an option.
void refuse_unknown_verb(std::span<const Verb> verbs, std::span<const char* const> words);

/// Lets `verb` take any number of arguments more, for refuse_extras. CLI11 would end a verb that takes
/// none at '--', and what follows would be lost.
void take_extra_arguments(CLI::App& verb);

/// Refuses what CLI11 did not know what to do with. `command` is "pupflow VERB".
void refuse_extras(const CLI::App& app, const std::string& command);

/// Refuses an option as the value of another: `--csv --pups p.csv` lacks the name of a file.
void refuse_taken_options(const CLI::App& app, const std::string& command);

/// CLI11's message in this program's words: the option as it was typed, and what is wrong with it.
io::Failure bad_command_line(const CLI::ParseError& error, const CLI::App& app,
                             const std::string& command, std::span<const char* const> words);

}  // namespace pupflow::cli
