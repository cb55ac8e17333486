// What this program was built with and what it runs on.
#pragma once

#include <string>

namespace pupflow::io {

/// The compiler's name and version, and the type of build.
std::string compiler_words();

/// The instruction set that the engine's loops use here, and those that they could.
std::string kernel_words();

/// The processor's name as the system tells it; "unknown" where it does not.
std::string cpu_name();

/// The path of the program of that name in the folders of PATH; empty where there is none. Folders
/// that PATH names relative to the current one are passed over.
std::string program_path(const std::string& name);

}  // namespace pupflow::io
