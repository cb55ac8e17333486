// Files that runs left when they were killed or the disk was full.
#pragma once

#include <span>
#include <string>

namespace pupflow::io {

/// Says in one line on standard error which unfinished files in the folders of `outputs` (files, or
/// empty) no process writes any more. They are left alone.
void name_unfinished(std::span<const std::string> outputs);

}  // namespace pupflow::io
