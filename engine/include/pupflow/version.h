/// @file
/// The version of the library, which is that of the program.
#pragma once

#include <string_view>

#pragma GCC visibility push(default)
namespace pupflow {

/// Semantic versioning: https://semver.org.
struct Version {
  int major;  ///< incompatible changes
  int minor;  ///< new features
  int patch;  ///< fixes
};

/// That of the library which is linked.
Version version();

/// The same as text, e.g. "0.2.0".
std::string_view version_text();

}  // namespace pupflow
#pragma GCC visibility pop
