// Independent pieces of work of a report, on several threads.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/report/report.h"

namespace pupflow::report {

/// Calls `work` with 0 ... count - 1, each once, on `options.threads` threads; shows progress as
/// `what` unless `options.quiet`. Throws io::Failure(interrupted) when Ctrl-C came: no new piece is
/// begun then, and those under way end. An exception of `work` ends the rest and comes out of here.
void share_out(const std::string& what, std::int64_t count, const Options& options,
               const std::function<void(std::int64_t)>& work);

}  // namespace pupflow::report
