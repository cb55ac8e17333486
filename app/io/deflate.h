// Chunks of HDF5 data sets as its filters shuffle and gzip store them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pupflow::io {

/// Does the work of these filters with ISA-L, which takes a tenth of the time that zlib takes.
class ChunkDeflater {
 public:
  ChunkDeflater();

  /// `chunk`, of numbers of `size` bytes each, shuffled and compressed. Empty where that takes as
  /// many bytes as the chunk or more. Valid until the next call.
  std::span<const std::byte> deflate(std::span<const std::byte> chunk, std::size_t size);

 private:
  std::vector<std::byte> shuffled_, deflated_;
  std::vector<std::uint8_t> tables_;
};

}  // namespace pupflow::io
