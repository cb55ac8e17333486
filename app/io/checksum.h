// One number that tells whether bytes are still those that were written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace pupflow::io {

/// The CRC-64 of `bytes` (ECMA-182, reflected: "CRC-64/XZ"). `before` is the checksum of what
/// stands before them. Every change within 64 bits in a row changes it.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before = 0);
std::uint64_t checksum(std::string_view text, std::uint64_t before = 0);

}  // namespace pupflow::io
