#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <array>
#include <random>

namespace pupflow::fuzz {
namespace {

using Chance = std::mt19937_64;

std::size_t below(Chance& chance, std::size_t end) {
  return end == 0 ? 0 : chance() % end;
}

/// Numbers at which programs go wrong.
constexpr std::array<std::uint64_t, 12> kNumbers{
    0, 1, 2, 0x7f, 0x80, 0xff, 0x7fffffff, 0x80000000, 0xffffffff, 1ULL << 62, 1ULL << 63, ~0ULL};

/// Writes a number of 1, 2, 4 or 8 bytes somewhere, or adds a little to what is there.
void put_number(Chance& chance, std::string& bytes) {
  const std::size_t size = std::size_t{1} << below(chance, 4);
  if (bytes.size() < size) return;
  const std::size_t at = below(chance, bytes.size() - size + 1);
  const std::uint64_t number = kNumbers[below(chance, kNumbers.size())];
  const bool adds = below(chance, 2) == 0;
  const std::uint64_t step = 1 + below(chance, 32);
  std::uint64_t old = 0;
  for (std::size_t i = size; i-- > 0;) old = old << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  std::uint64_t value = !adds ? number : below(chance, 2) == 0 ? old + step : old - step;
  for (std::size_t i = 0; i < size; ++i, value >>= 8)
    bytes[at + i] = static_cast<char>(value & 255);
}

void change(Chance& chance, std::string& bytes, const std::string& other) {
  const std::size_t at = below(chance, bytes.size());
  const std::size_t length = 1 + below(chance, 64), from = below(chance, other.size());
  const std::string piece = other.substr(from, length);
  switch (below(chance, 8)) {
    case 0:
      bytes.erase(at, length);
      break;
    case 1:
      bytes.insert(at, piece);
      break;
    case 2:
      bytes.replace(at, piece.size(), piece);
      break;
    case 3:
    case 4:
      put_number(chance, bytes);
      break;
    default:
      if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(chance, 8)));
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& seeds, std::uint64_t number) {
  Chance chance(number);
  std::string bytes = seeds[below(chance, seeds.size())];
  std::size_t longest = 0;
  for (const std::string& seed : seeds) longest = std::max(longest, seed.size());
  for (std::size_t changes = 1 + below(chance, 8); changes > 0; --changes) {
    const bool of_itself = below(chance, 2) == 0;
    const std::string other = of_itself ? bytes : seeds[below(chance, seeds.size())];
    change(chance, bytes, other);
  }
  bytes.resize(std::min(bytes.size(), 2 * longest));
  return bytes;
}

}  // namespace pupflow::fuzz
