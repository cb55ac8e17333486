// TOML files that hold plain values, a key each.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pupflow::io {

struct TomlValue {
  /// Nothing: it is of another kind.
  std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::string>>
      value;
  std::string where;  // "NAME:line:column"
};

/// The values at the top of the file `name`, whose text is `text`, by their keys. Throws
/// Failure(bad_file), "NAME:line:column: ...", where the text is no TOML.
std::map<std::string, TomlValue, std::less<>> toml_values(std::string_view text,
                                                          const std::string& name);

}  // namespace pupflow::io
