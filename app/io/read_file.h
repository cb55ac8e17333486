// Input files, whole in memory.
#pragma once

#include <cstddef>
#include <string>

namespace pupflow::io {

/// The bytes of `path` ("-" is standard input), which may be a pipe: Ctrl-C ends the wait for one.
/// Throws Failure: bad_file with the path and the reason, also when there are more than `limit`
/// bytes; interrupted.
std::string read_file(const std::string& path, std::size_t limit);

/// The first bytes of `path`, at most `count`. Only of a regular file, which can be read again from
/// its beginning. Throws Failure(bad_file) with the path and the reason.
std::string read_beginning(const std::string& path, std::size_t count);

}  // namespace pupflow::io
