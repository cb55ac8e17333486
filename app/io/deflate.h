// Chunks of HDF5 data sets as its filters shuffle and gzip store them.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <span>
#include <vector>

namespace pupflow::io {

/// What the filters make of a chunk. Keeps its memory from chunk to chunk, which the filters of the
/// library do not: for small chunks they take longer to begin than to work.
class ChunkDeflater {
 public:
  ChunkDeflater();
  ~ChunkDeflater();
  ChunkDeflater(const ChunkDeflater&) = delete;
  ChunkDeflater& operator=(const ChunkDeflater&) = delete;

  /// `chunk`, of numbers of `size` bytes each, shuffled and compressed. Empty where that takes as
  /// many bytes as the chunk or more. Valid until the next call.
  std::span<const std::byte> deflate(std::span<const std::byte> chunk, std::size_t size);

 private:
  z_stream small_{}, large_{};  // for chunks up to and above kSmallChunk
  std::vector<std::byte> shuffled_, deflated_;
};

}  // namespace pupflow::io
