// Text of JSON values.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pupflow::io {

/// A string, its control characters escaped.
std::string json_string(std::string_view text);

/// A number in its shortest form; null where it is not finite, which JSON has no number for.
std::string json_number(double value);

std::string json_bool(bool value);

/// An array of strings, on one line.
std::string json_strings(std::span<const std::string_view> texts);

/// An object: keys, and values that are JSON already.
using JsonObject = std::vector<std::pair<std::string_view, std::string>>;

/// One object, on one line.
std::string json_object(const JsonObject& object);

/// One object, a key a line: a whole file.
std::string json_file(const JsonObject& object);

/// An array of values that are JSON already, on one line.
std::string json_array(std::span<const std::string> values);

/// An array of objects, one a line.
std::string json_objects(const std::vector<JsonObject>& objects);

}  // namespace pupflow::io
