// Data sets of files: their numbers and shapes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pupflow::io {

/// The numbers of a data set: their kind and bytes each.
enum class NumberType { f8, f4, i8, i4, i2, u1 };

std::size_t byte_size(NumberType type);

/// What it is called, such as "f8", and the type of that name; nothing for others.
std::string_view type_name(NumberType type);
std::optional<NumberType> number_type(std::string_view name);

/// Stands for a value that is not known in data sets of integers; NaN does among other numbers.
template <class Integer>
inline constexpr Integer kNotKnown = std::is_signed_v<Integer>
                                         ? std::numeric_limits<Integer>::min()
                                         : std::numeric_limits<Integer>::max();

/// A data set as a file has it.
struct SetInfo {
  std::string name;                  // with its groups: "pup/tb"
  std::vector<std::uint64_t> shape;  // frames first where it grows
  std::string type;                  // "f8", "f4", "i8", ...: kind and bytes; empty for others
  std::string units, description;
};

}  // namespace pupflow::io
