#include "app/cli/parse.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/pictures/look.h"

namespace pupflow::cli {
namespace {

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

[[noreturn]] void fail(const std::string& option, std::string_view text, const std::string& right) {
  throw io::Failure(io::ExitCode::bad_input,
                    option + " " + io::quoted(text) + ": must be " + right);
}

}  // namespace

std::pair<int, int> parse_size(const std::string& option, const std::string& text) {
  const auto parts = split(text, 'x');
  if (parts.size() == 2) {
    const auto width = number_in<int>(parts[0]), height = number_in<int>(parts[1]);
    const auto fits = [](const auto& n) {
      return n && *n >= pictures::kSmallestSide && *n <= pictures::kLargestSide;
    };
    if (fits(width) && fits(height)) return {*width, *height};
  }
  fail(option, text,
       "WIDTHxHEIGHT in pixels, each " + std::to_string(pictures::kSmallestSide) + " ... " +
           std::to_string(pictures::kLargestSide) + ", e.g. 1280x960");
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const auto number = number_in<double>(part);
    if (!number || !std::isfinite(*number)) fail(option, text, "numbers joined by commas");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::int64_t> parse_steps(const std::string& option, const std::string& text) {
  constexpr std::int64_t kLast = (std::int64_t{1} << 53) - 1;  // as the parameter `steps`
  std::vector<std::int64_t> steps;
  for (const std::string_view part : split(text, ',')) {
    const auto step = number_in<std::int64_t>(part);
    if (!step || *step < 0 || *step > kLast) {
      fail(option, text, "step numbers joined by commas, e.g. 500,1500 (0 is the start)");
    }
    steps.push_back(*step);
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

}  // namespace pupflow::cli
