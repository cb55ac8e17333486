#include "app/io/toml_values.h"

#include <toml++/toml.h>

#include <algorithm>

#include "app/io/failure.h"
#include "app/io/toml_depth.h"
#include "app/io/toml_problem.h"

namespace pupflow::io {
namespace {

std::string place(const std::string& name, const toml::source_region& where) {
  return name + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column);
}

decltype(TomlValue::value) value_of(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* real = node.as_floating_point()) return real->get();
  if (const auto* word = node.as_string()) return word->get();
  const toml::array* items = node.as_array();
  const auto is_text = [](const toml::node& item) { return item.is_string(); };
  if (items == nullptr || !std::all_of(items->begin(), items->end(), is_text)) return {};
  std::vector<std::string> words;
  for (const toml::node& item : *items) words.push_back(item.as_string()->get());
  return words;
}

}  // namespace

std::map<std::string, TomlValue, std::less<>> toml_values(std::string_view text,
                                                          const std::string& name) {
  if (const std::string deep = too_deep(text); !deep.empty()) {
    throw Failure(ExitCode::bad_file, name + ":" + deep);
  }
  std::map<std::string, TomlValue, std::less<>> values;
  try {
    for (const auto& [key, node] : toml::parse(text, name)) {
      values[std::string(key.str())] = {value_of(node), place(name, node.source())};
    }
  } catch (const toml::parse_error& error) {
    throw Failure(ExitCode::bad_file,
                  place(name, error.source()) + ": " + toml_problem(error.description()));
  }
  return values;
}

}  // namespace pupflow::io
