#include "tests/fuzz/fuzz.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "app/io/checksum.h"
#include "app/io/user_block.h"
#include "tests/support/scratch.h"

namespace pupflow::fuzz {
namespace {

std::uint64_t inputs = 0;

const test::Scratch& scratch() {
  static const test::Scratch folder;
  return folder;
}

}  // namespace

void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

void require_sound(const std::string& message) {
  constexpr std::size_t kLongest = 1 << 20;
  require(message.find_first_not_of(" \n") == 0, "a message begins with nothing: " + message);
  require(message.size() <= kLongest, "a message is too long to be read");
}

std::string file_of(std::string_view bytes) {
  ++inputs;
  return scratch().file("input", std::string(bytes));
}

std::uint64_t input_number() {
  return inputs;
}

std::string hdf5_file_of(std::string_view bytes, const std::string& kind) {
  if (bytes.size() < io::kUserBlock || bytes.starts_with("\x89HDF")) return file_of(bytes);
  const std::string_view rest = bytes.substr(io::kUserBlock);
  return file_of(io::block_text({kind, bytes.size(), io::checksum(rest)}) + std::string(rest));
}

std::string no_file() {
  std::filesystem::remove(scratch().path("output"));
  return scratch().path("output");
}

bool is_long(std::string_view range) {
  constexpr double kMost = 10'000;
  double product = 1, number = 0;
  for (const char letter : range) {
    const bool digit = letter >= '0' && letter <= '9';
    if (!digit) product *= std::max(number, 1.0);
    number = digit ? 10 * number + (letter - '0') : 0;
  }
  return product * std::max(number, 1.0) > kMost;
}

std::uint8_t Source::byte() {
  if (rest_.empty()) return 0;
  const auto value = static_cast<std::uint8_t>(rest_.front());
  rest_.remove_prefix(1);
  return value;
}

double Source::share() {
  const int high = byte(), low = byte();
  return (256 * high + low) / 65535.0;
}

double Source::number() {
  double value = 0;
  const std::size_t size = std::min(rest_.size(), sizeof value);
  std::memcpy(&value, rest_.data(), size);
  rest_.remove_prefix(size);
  return value;
}

}  // namespace pupflow::fuzz
