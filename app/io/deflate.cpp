#include "app/io/deflate.h"

#include <new>

namespace pupflow::io {
namespace {

// zlib clears its tables for each chunk: small tables for small chunks.
constexpr std::size_t kSmallChunk = 4096;
constexpr int kFastest = 1;

void begin(z_stream& stream, int window_bits, int memory_level) {
  if (deflateInit2(&stream, kFastest, Z_DEFLATED, window_bits, memory_level, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::bad_alloc();
  }
}

/// All first bytes of the numbers, then all second ones, and so on.
void shuffle(std::span<const std::byte> chunk, std::size_t size, std::vector<std::byte>& to) {
  to.resize(chunk.size());
  const std::size_t count = chunk.size() / size;
  for (std::size_t byte = 0; byte < size; ++byte) {
    std::byte* const out = to.data() + byte * count;
    for (std::size_t i = 0; i < count; ++i) out[i] = chunk[i * size + byte];
  }
}

}  // namespace

ChunkDeflater::ChunkDeflater() {
  begin(small_, 12, 5);
  begin(large_, 15, 8);
}

ChunkDeflater::~ChunkDeflater() {
  deflateEnd(&small_);
  deflateEnd(&large_);
}

std::span<const std::byte> ChunkDeflater::deflate(std::span<const std::byte> chunk,
                                                  std::size_t size) {
  shuffle(chunk, size, shuffled_);
  z_stream& stream = chunk.size() <= kSmallChunk ? small_ : large_;
  deflated_.resize(chunk.size());
  deflateReset(&stream);
  stream.next_in = reinterpret_cast<Bytef*>(shuffled_.data());
  stream.avail_in = static_cast<uInt>(shuffled_.size());
  stream.next_out = reinterpret_cast<Bytef*>(deflated_.data());
  stream.avail_out = static_cast<uInt>(deflated_.size());
  if (::deflate(&stream, Z_FINISH) != Z_STREAM_END) return {};
  return std::span(deflated_).first(stream.total_out);
}

}  // namespace pupflow::io
