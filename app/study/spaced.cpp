#include "app/study/spaced.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>

#include "app/io/text.h"
#include "pupflow/parameters.h"

namespace pupflow::study {
namespace {

std::string_view without_plus(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return text;
}

double number(std::string_view text) {
  return io::read_number<double>(without_plus(text)).value_or(0);
}

/// digits * 10^exponent.
struct Decimal {
  std::int64_t digits;
  int exponent;
};

/// Nothing where the digits do not fit.
std::optional<Decimal> read_decimal(std::string_view text) {
  int exponent = 0;
  const std::size_t e = text.find_first_of("eE");
  if (e != std::string_view::npos) {
    const auto power = io::read_number<int>(without_plus(text.substr(e + 1)));
    if (!power || *power < -99 || *power > 99) return std::nullopt;
    exponent = *power;
  }
  std::string digits(without_plus(text.substr(0, e)));
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const auto whole = io::read_number<std::int64_t>(digits);
  if (!whole) return std::nullopt;
  return Decimal{*whole, exponent};
}

/// Multiplies by 10^power; false where that does not fit.
bool scale(std::int64_t& number, int power) {
  for (; power > 0 && number != 0; --power) {
    if (__builtin_mul_overflow(number, std::int64_t{10}, &number)) return false;
  }
  return true;
}

/// (a * times_a + b * times_b) / divisor. A quotient of exact doubles is rounded once.
std::optional<double> quotient(const std::optional<Decimal>& a, std::int64_t times_a,
                               const std::optional<Decimal>& b, std::int64_t times_b,
                               std::int64_t divisor) {
  if (!a || !b) return std::nullopt;
  const int exponent = std::min({a->exponent, b->exponent, 0});
  std::int64_t left = a->digits, right = b->digits, sum = 0;
  if (!scale(left, a->exponent - exponent) || !scale(right, b->exponent - exponent) ||
      !scale(divisor, -exponent) || __builtin_mul_overflow(left, times_a, &left) ||
      __builtin_mul_overflow(right, times_b, &right) || __builtin_add_overflow(left, right, &sum)) {
    return std::nullopt;
  }
  const std::int64_t common = std::gcd(sum, divisor);
  const auto above = static_cast<double>(sum / common),
             below = static_cast<double>(divisor / common);
  if (std::abs(above) > kExactInteger || below > kExactInteger) return std::nullopt;
  return above / below;
}

}  // namespace

std::vector<double> spaced(std::string_view from, std::string_view to, std::int64_t count) {
  const auto first = read_decimal(from), last = read_decimal(to);
  const double low = number(from), high = number(to);
  std::vector<double> values{low};
  for (std::int64_t i = 1; i < count - 1; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    values.push_back(
        quotient(first, count - 1 - i, last, i, count - 1).value_or(low + (high - low) * share));
  }
  values.push_back(high);
  return values;
}

std::vector<double> stepped(std::string_view from, std::string_view to, std::string_view step,
                            std::int64_t most) {
  constexpr double kTolerance = 1e-9;
  const auto first = read_decimal(from), size = read_decimal(step);
  const double low = number(from), high = number(to), width = number(step);
  const double steps = std::floor(std::abs(high - low) / width + kTolerance);
  if (!(steps < static_cast<double>(most))) return {};
  const std::int64_t sign = high < low ? -1 : 1;
  std::vector<double> values{low};
  for (std::int64_t i = 1; i <= static_cast<std::int64_t>(steps); ++i) {
    const double value =
        quotient(first, 1, size, sign * i, 1).value_or(low + static_cast<double>(sign * i) * width);
    values.push_back(std::abs(value - high) <= kTolerance * width ? high : value);
  }
  return values;
}

}  // namespace pupflow::study
