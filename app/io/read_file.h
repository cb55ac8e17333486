// Input files, whole in memory.
#pragma once

#include <cstddef>
#include <string>

namespace pupflow::io {

/// The bytes of `path` ("-" is standard input). Throws Failure(bad_file) that names the path and
/// the reason; also when there are more than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit);

/// The first bytes of `path`, at most `count`. Throws like read_file.
std::string read_beginning(const std::string& path, std::size_t count);

}  // namespace pupflow::io
