#include "app/io/data_set.h"

#include <array>

namespace pupflow::io {
namespace {

constexpr std::array<std::string_view, 6> kNames{"f8", "f4", "i8", "i4", "i2", "u1"};

}  // namespace

std::size_t byte_size(NumberType type) {
  return static_cast<std::size_t>(type_name(type)[1] - '0');
}

std::string_view type_name(NumberType type) {
  return kNames[static_cast<std::size_t>(type)];
}

std::optional<NumberType> number_type(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<NumberType>(i);
  }
  return std::nullopt;
}

}  // namespace pupflow::io
