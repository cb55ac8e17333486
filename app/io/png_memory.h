// PNG files that are in memory already.
#pragma once

#include <string>
#include <string_view>

#include "app/io/png.h"

namespace pupflow::io {

/// The PNG in `bytes` as RGBA. Throws Failure(bad_file), which names it `name`.
Image read_png(std::string_view bytes, const std::string& name);

}  // namespace pupflow::io
