#include "app/io/json.h"

#include <cmath>

#include "app/io/text.h"

namespace pupflow::io {
namespace {

std::string member(const std::pair<std::string_view, std::string>& entry) {
  return json_string(entry.first) + ": " + entry.second;
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) {
      result += formatted("\\u%04x", static_cast<unsigned>(c));
      continue;
    }
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

std::string json_object(const JsonObject& object) {
  return "{" + joined(object, ", ", member) + "}";
}

std::string json_file(const JsonObject& object) {
  const auto line = [](const auto& entry) { return "  " + member(entry); };
  return "{\n" + joined(object, ",\n", line) + "\n}\n";
}

std::string json_array(std::span<const std::string> values) {
  return "[" + joined(values, ", ") + "]";
}

std::string json_objects(const std::vector<JsonObject>& objects) {
  const auto line = [](const JsonObject& object) { return "  " + json_object(object); };
  return "[\n" + joined(objects, ",\n", line) + "\n]\n";
}

}  // namespace pupflow::io
