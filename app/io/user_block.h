// The first 512 bytes of this program's HDF5 files. HDF5 leaves them to the writer (a "user block");
// here they hold a line that says what the file is and which checksum its bytes have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pupflow::io {

inline constexpr std::size_t kUserBlock = 512;

/// The first bytes of HDF5's own, at the beginning of a file or behind its block.
inline constexpr std::string_view kHdf5Signature = "\x89HDF\r\n\x1a\n";

/// Larger files are not read as a whole to find their checksum.
inline constexpr std::uint64_t kLargestChecked = std::uint64_t{1} << 30;

/// What the line says.
struct UserBlock {
  std::string kind;                       // "checkpoint" or "recording"
  std::optional<std::uint64_t> size;      // of the file, bytes; none while it is unfinished
  std::optional<std::uint64_t> checksum;  // of what follows the block; none above kLargestChecked
};

/// The block as a file has it, kUserBlock bytes.
std::string block_text(const UserBlock& block);

/// The block at the beginning of an HDF5 file; nothing where it begins with HDF5's signature, as files
/// before 0.2.0 do. Throws Failure(bad_file), naming `path`, when it is neither.
std::optional<UserBlock> read_user_block(const std::string& path, std::string_view beginning);

/// Throws Failure(bad_file) when the size of `path` is not what `block` says, or its bytes do not
/// have its checksum. Does nothing for an unfinished file.
void check_against(const UserBlock& block, const std::string& path);

/// The same for a file in memory.
void check_against(const UserBlock& block, const std::string& path, std::string_view bytes);

/// The block of a finished file of that kind, which lies at `path` and has room for it.
UserBlock block_of(const std::string& kind, const std::string& path);

}  // namespace pupflow::io
