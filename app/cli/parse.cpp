#include "app/cli/parse.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/pictures/look.h"

namespace pupflow::cli {
namespace {

[[noreturn]] void fail(const std::string& option, std::string_view text, const std::string& right) {
  io::refuse(option + " " + io::quoted(text) + ": must be " + right);
}

}  // namespace

std::pair<int, int> parse_size(const std::string& option, const std::string& text) {
  const auto parts = io::split(text, 'x');
  if (parts.size() == 2) {
    const auto width = io::read_number<int>(parts[0]), height = io::read_number<int>(parts[1]);
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

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  const std::string& right) {
  std::vector<double> numbers;
  for (const std::string_view part : io::split(text, ',')) {
    const auto number = io::read_number<double>(part);
    if (!number || !std::isfinite(*number)) fail(option, text, right);
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::int64_t> parse_steps(const std::string& option, const std::string& text) {
  constexpr std::int64_t kLast = (std::int64_t{1} << 53) - 1;  // as the parameter `steps`
  std::vector<std::int64_t> steps;
  for (const std::string_view part : io::split(text, ',')) {
    const auto step = io::read_number<std::int64_t>(part);
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
