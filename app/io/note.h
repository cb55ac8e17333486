// What the user should know beside the result.
#pragma once

#include <string>

namespace pupflow::io {

/// One line on standard error, "pupflow: note: TEXT", printable.
void note(const std::string& text);

}  // namespace pupflow::io
