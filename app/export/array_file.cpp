#include "app/export/array_file.h"

#include <bit>

namespace pupflow::exporting {

std::string npy_type(io::NumberType type) {
  constexpr bool kLittle = std::endian::native == std::endian::little;
  return (kLittle ? "<" : ">") + std::string(io::type_name(type));
}

std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string sizes;
  for (const std::size_t size : shape) sizes += std::to_string(size) + ",";
  std::string text =
      "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + sizes + "), }";
  const std::size_t before = 10;  // magic, version, length
  text.append(63 - (before + text.size()) % 64, ' ');
  text += '\n';
  std::string header = "\x93NUMPY";
  header += '\x01';
  header += '\0';
  header += static_cast<char>(text.size() & 0xFF);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

}  // namespace pupflow::exporting
