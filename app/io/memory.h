// How much memory there is for something large.
#pragma once

#include <cstdint>
#include <string>

namespace pupflow::io {

/// Bytes that this process may still take of its address space (ulimit -v).
std::uint64_t address_space_left();

/// Bytes that this process may still take: of the machine's memory, of its control group's, of its
/// address space. What the system does not tell limits nothing.
std::uint64_t memory_left();

/// Throws Failure(bad_input) when less than `bytes` are left: "WHAT needs about 15 GB of memory, of
/// which 4 GB are free; RIGHT".
void refuse_large(const std::string& what, double bytes, const std::string& right);

}  // namespace pupflow::io
