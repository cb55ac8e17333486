// Work that may crash in somebody else's code, tried in another process first.
#pragma once

#include <functional>

namespace pupflow::io {

/// Does `work` in a copy of this process, of which nothing remains. Returns false when it crashed
/// there or took more than `seconds` of processor time; what it threw is no crash. Returns true where there
/// can be no other process.
bool ends_well(unsigned seconds, const std::function<void()>& work);

}  // namespace pupflow::io
