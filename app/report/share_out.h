// Independent tasks of a report on several threads, with progress and Ctrl-C.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/report/report.h"

namespace pupflow::report {

/// Calls `work` with each of 0 ... count - 1 once, on `options.threads` threads, and shows progress
/// as `what` unless `options.quiet`. After Ctrl-C no further call is begun, and when those under way
/// have ended io::Failure(interrupted) is thrown. Throws what `work` throws.
void share_out(const std::string& what, std::int64_t count, const Options& options,
               const std::function<void(std::int64_t)>& work);

}  // namespace pupflow::report
