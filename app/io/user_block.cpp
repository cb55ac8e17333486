#include "app/io/user_block.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/io/checksum.h"
#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

[[noreturn]] void damaged(const std::string& path, const std::string& what) {
  throw Failure(ExitCode::bad_file, path + ": is damaged: " + what);
}

/// "NAME VALUE" among the parts of the line.
std::string_view part(const std::vector<std::string_view>& parts, std::string_view name) {
  for (const std::string_view text : parts) {
    if (text.starts_with(name)) return text.substr(name.size());
  }
  return {};
}

/// The checksum of what follows the block in a file of `size` bytes.
std::uint64_t checksum_behind_block(const std::string& path, std::uint64_t size) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(kUserBlock);
  std::string bytes(std::size_t{1} << 20, '\0');
  std::uint64_t sum = 0;
  for (std::uint64_t at = kUserBlock; at < size;) {
    const std::uint64_t count = std::min<std::uint64_t>(bytes.size(), size - at);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(count))) {
      throw Failure(ExitCode::bad_file, path + ": cannot read all of it");
    }
    sum = checksum(std::string_view(bytes).substr(0, count), sum);
    at += count;
  }
  return sum;
}

std::uint64_t size_of(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw Failure(ExitCode::bad_file, path + ": cannot read: " + error.message());
  return size;
}

void compare_size(const UserBlock& block, const std::string& path, std::uint64_t size) {
  if (size == *block.size) return;
  damaged(path, "has " + std::to_string(size) + " bytes, and was written with " +
                    std::to_string(*block.size));
}

void compare_sum(const UserBlock& block, const std::string& path, std::uint64_t sum) {
  if (sum == block.checksum) return;
  damaged(path, "its bytes are not those that were written (or another program changed it)");
}

}  // namespace

std::string block_text(const UserBlock& block) {
  std::string text = "pupflow " + block.kind;
  if (block.size) {
    text += ", bytes " + std::to_string(*block.size);
    if (block.checksum) text += ", checksum " + hash_text(*block.checksum);
  } else {
    text += ", unfinished";
  }
  text += '\n';
  text.resize(kUserBlock, '\0');
  return text;
}

std::optional<UserBlock> read_user_block(const std::string& path, std::string_view beginning) {
  if (beginning.starts_with(kHdf5Signature)) return std::nullopt;
  const bool whole = beginning.size() >= kUserBlock;
  const auto parts = split(beginning.substr(0, beginning.find('\n')), ',');
  UserBlock block{std::string(part(parts, "pupflow ")),
                  read_number<std::uint64_t>(part(parts, " bytes ")),
                  read_hash(part(parts, " checksum "))};
  if (block.kind != "checkpoint" && block.kind != "recording") {
    throw Failure(ExitCode::bad_file, path +
                                          ": cannot read: is no HDF5 file of this program, or "
                                          "damaged");
  }
  // Every byte of the block follows from what it says.
  const bool never = block.kind == "checkpoint" && !block.size;  // unfinished ones have other names
  if (!whole || never || block_text(block) != beginning.substr(0, kUserBlock)) {
    damaged(path, "its first line is not one that this program writes");
  }
  return block;
}

void check_against(const UserBlock& block, const std::string& path) {
  if (!block.size) return;
  compare_size(block, path, size_of(path));
  if (block.checksum) compare_sum(block, path, checksum_behind_block(path, *block.size));
}

void check_against(const UserBlock& block, const std::string& path, std::string_view bytes) {
  if (!block.size) return;
  compare_size(block, path, bytes.size());
  if (block.checksum) compare_sum(block, path, checksum(bytes.substr(kUserBlock)));
}

UserBlock block_of(const std::string& kind, const std::string& path) {
  const std::uint64_t size = size_of(path);
  UserBlock block{kind, size, {}};
  if (size <= kLargestChecked) block.checksum = checksum_behind_block(path, size);
  return block;
}

}  // namespace pupflow::io
