// A PNG file, with its checksums put right. Invariant: text and picture are each refused in one sound
// line or read; what was read comes back the same from the file that it is written to.
#include "app/io/png.h"

#include <zlib.h>

#include <algorithm>

#include "app/io/params_of_file.h"
#include "tests/fuzz/fuzz.h"

namespace pupflow::fuzz {
namespace {

constexpr std::size_t kSignature = 8, kFrame = 12;  // of a chunk: size, name, checksum

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = 256 * number + static_cast<std::uint8_t>(bytes[i]);
  return number;
}

/// Writes the checksum of each whole chunk.
std::string with_checksums(std::string bytes) {
  for (std::size_t at = kSignature; at + kFrame <= bytes.size();) {
    const std::size_t size = big_endian(bytes, at), end = at + kFrame + size;
    if (end > bytes.size()) break;
    const auto* const name = reinterpret_cast<const unsigned char*>(bytes.data()) + at + 4;
    std::uint32_t sum = static_cast<std::uint32_t>(crc32(0, name, static_cast<uInt>(size + 4)));
    for (std::size_t i = end; i-- > end - 4; sum >>= 8) bytes[i] = static_cast<char>(sum & 255);
    at = end;
  }
  return bytes;
}

}  // namespace

void one_input(std::string_view bytes) {
  const std::string path = file_of(with_checksums(std::string(bytes)));
  refuses([&] { io::read_png_text(path); });
  refuses([&] { io::params_of_file(path); });
  refuses([&] {
    const io::Image image = io::read_png(path);
    require(image.rgba.size() ==
                4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
            "a picture has another size than its pixels");
  });
}

}  // namespace pupflow::fuzz
