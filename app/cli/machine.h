// What this program was built with and what it runs on.
#pragma once

#include <string>
#include <vector>

namespace pupflow::cli {

/// The compiler's name and version.
std::string compiler_words();

/// Instruction sets that the compiler was allowed to use, e.g. "SSE2".
std::string built_for();

/// The processor's name as the system tells it; "unknown" where it does not.
std::string cpu_name();

/// Of the instruction sets that matter here, those that the processor has; empty where the system
/// does not tell.
std::vector<std::string> cpu_features();

}  // namespace pupflow::cli
