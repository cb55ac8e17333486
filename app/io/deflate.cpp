#include "app/io/deflate.h"

#include <isa-l.h>

namespace pupflow::io {
namespace {

// Level 1 packs better, but clears its tables for each chunk.
constexpr std::size_t kSmallChunk = 4096;

/// All first bytes of the numbers, then all second ones, and so on.
template <std::size_t kSize>
void shuffle(std::span<const std::byte> chunk, std::byte* to) {
  const std::size_t count = chunk.size() / kSize;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t byte = 0; byte < kSize; ++byte) to[byte * count + i] = chunk[i * kSize + byte];
  }
}

}  // namespace

ChunkDeflater::ChunkDeflater() : tables_(ISAL_DEF_LVL1_DEFAULT) {}

std::span<const std::byte> ChunkDeflater::deflate(std::span<const std::byte> chunk,
                                                  std::size_t size) {
  shuffled_.resize(chunk.size());
  deflated_.resize(chunk.size());
  switch (size) {
    case 2:
      shuffle<2>(chunk, shuffled_.data());
      break;
    case 4:
      shuffle<4>(chunk, shuffled_.data());
      break;
    case 8:
      shuffle<8>(chunk, shuffled_.data());
      break;
    default:
      shuffle<1>(chunk, shuffled_.data());
  }
  isal_zstream stream;
  isal_deflate_stateless_init(&stream);
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.flush = NO_FLUSH;
  if (chunk.size() > kSmallChunk) {
    stream.level = 1;
    stream.level_buf = tables_.data();
    stream.level_buf_size = static_cast<std::uint32_t>(tables_.size());
  }
  stream.next_in = reinterpret_cast<std::uint8_t*>(shuffled_.data());
  stream.avail_in = static_cast<std::uint32_t>(shuffled_.size());
  stream.next_out = reinterpret_cast<std::uint8_t*>(deflated_.data());
  stream.avail_out = static_cast<std::uint32_t>(deflated_.size());
  if (isal_deflate_stateless(&stream) != COMP_OK) return {};
  return std::span(deflated_).first(stream.total_out);
}

}  // namespace pupflow::io
