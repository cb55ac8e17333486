// What shells offer as the next word.
#pragma once

#include <string>
#include <vector>

#include "app/cli/manual.h"

namespace pupflow::cli {

/// The words that may stand for an argument written as `argument`, e.g. the parameters with '=' for
/// NAME=VALUE, the names of a|b|c, the shipped scenes for SCENE. Empty: a file or a number.
std::vector<std::string> words_for(const std::string& argument);

/// The names of an option or verb, each on its own: "-o, --out" gives both.
std::vector<std::string> single_names(const Page::Entry& entry);

}  // namespace pupflow::cli
