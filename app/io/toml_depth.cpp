#include "app/io/toml_depth.h"

#include <algorithm>

namespace pupflow::io {
namespace {

/// Where the string that begins at `at` ends: behind its closing quotes.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool is_long = text.substr(at).starts_with(three);
  const std::string_view close = is_long ? std::string_view(three) : text.substr(at, 1);
  for (at += close.size(); at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text.substr(at).starts_with(close)) {
      at += close.size();
      while (is_long && at < text.size() && text[at] == quote) ++at;  // """" ends in a quote
      return at;
    } else if (!is_long && text[at] == '\n') {
      return at;  // not closed
    }
  }
  return text.size();
}

}  // namespace

std::string too_deep(std::string_view text) {
  constexpr int kMostDots = 31;
  constexpr std::string_view kBreaks = "\n=,[]{}";  // no key goes on beyond these
  int dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '"' || text[at] == '\'') {
      at = after_string(text, at);
      continue;
    }
    if (text[at] == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (kBreaks.find(text[at]) != std::string_view::npos) dots = 0;
    if (text[at] == '.' && ++dots > kMostDots) {
      const std::string_view before = text.substr(0, at);
      const std::size_t line_start = before.rfind('\n') + 1;  // 0 where there is none
      return std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + ":" +
             std::to_string(at - line_start + 1) + ": a key has more than " +
             std::to_string(kMostDots + 1) + " parts joined by dots";
    }
    ++at;
  }
  return {};
}

}  // namespace pupflow::io
