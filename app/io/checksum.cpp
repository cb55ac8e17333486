#include "app/io/checksum.h"

#include <isa-l.h>

namespace pupflow::io {

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before) {
  return crc64_ecma_refl(before, reinterpret_cast<const unsigned char*>(bytes.data()),
                         bytes.size());
}

std::uint64_t checksum(std::string_view text, std::uint64_t before) {
  return checksum(std::as_bytes(std::span(text)), before);
}

}  // namespace pupflow::io
