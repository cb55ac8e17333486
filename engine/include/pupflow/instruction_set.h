/// @file
/// The instruction sets that the loops over points are compiled for.
#pragma once

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace pupflow {

/// Results have the same bits with each.
enum class InstructionSet { baseline, avx2, avx512 };

/// "baseline" (SSE2 on x86-64, NEON on arm64), "avx2" or "avx512".
std::string_view instruction_set_name(InstructionSet set);

/// The instruction sets that both this processor and this build have, fastest last. Never empty.
std::span<const InstructionSet> supported_instruction_sets();

}  // namespace pupflow
#pragma GCC visibility pop
