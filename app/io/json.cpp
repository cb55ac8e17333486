#include "app/io/json.h"

#include <cmath>

#include "app/io/text.h"

namespace pupflow::io {

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string json_number(double value) {
  return std::isfinite(value) ? number_text(value) : "null";
}

std::string json_bool(bool value) {
  return value ? "true" : "false";
}

std::string json_strings(std::span<const std::string_view> texts) {
  return "[" + joined(texts, ", ", json_string) + "]";
}

std::string json_objects(const std::vector<JsonObject>& objects) {
  const auto member = [](const auto& entry) {
    return json_string(entry.first) + ": " + entry.second;
  };
  const auto line = [&](const JsonObject& object) {
    return "  {" + joined(object, ", ", member) + "}";
  };
  return "[\n" + joined(objects, ",\n", line) + "\n]\n";
}

}  // namespace pupflow::io
