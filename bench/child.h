// Programs as children of this one.
#pragma once

#include <string>
#include <vector>

namespace pupflow::bench {

/// Runs `program` with `arguments`, its output thrown away, and returns the time until it has
/// ended, in milliseconds. Throws std::runtime_error unless it ends with exit code 0.
double run_time(const std::string& program, const std::vector<std::string>& arguments);

/// The largest resident size that `work` reaches in a child of its own, in bytes. Throws
/// std::runtime_error when the child fails.
double peak_memory(void (*work)(int), int argument);

}  // namespace pupflow::bench
