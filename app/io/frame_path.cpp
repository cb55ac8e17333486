#include "app/io/frame_path.h"

#include "app/io/failure.h"

namespace pupflow::io {
namespace {

/// Where the number goes: its first character, its length in the pattern, and its least digits.
struct Place {
  std::size_t begin = std::string::npos;
  std::size_t length = 0;
  std::size_t digits = 1;
};

Place find_place(const std::string& pattern) {
  Place place;
  place.begin = pattern.find('%');
  if (place.begin == std::string::npos) return place;
  const std::string rest = pattern.substr(place.begin + 1);
  if (rest.starts_with('d')) {
    place.length = 2;
  } else if (rest.size() >= 3 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9' &&
             rest[2] == 'd') {
    place.length = 4;
    place.digits = static_cast<std::size_t>(rest[1] - '0');
  }
  if (place.length == 0 || pattern.find('%', place.begin + 1) != std::string::npos) {
    refuse(pattern + ": a file name may hold one %d or %0Nd (N = 1 ... 9), and no other %");
  }
  return place;
}

}  // namespace

bool has_number(const std::string& pattern) {
  return find_place(pattern).length > 0;
}

std::string frame_path(const std::string& pattern, std::int64_t number) {
  const Place place = find_place(pattern);
  if (place.length == 0) return pattern;
  std::string digits = std::to_string(number);
  if (digits.size() < place.digits) digits.insert(0, place.digits - digits.size(), '0');
  return std::string(pattern).replace(place.begin, place.length, digits);
}

}  // namespace pupflow::io
